// A child process with its standard input and output at hand.
#pragma once

#include <sys/types.h>

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "experiments/file_descriptor.h"

namespace raysweep {

/// Starts this very program anew, even if its file was replaced meanwhile. The child gets its own process
/// group, so Ctrl-C reaches only us; it dies with us, whatever kills us; and the destructor kills and reaps
/// it.
class Child {
 public:
  /// Throws WorkError if there is no process to be had.
  explicit Child(std::vector<std::string> arguments);
  ~Child();
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  /// The next line of its standard output, without the newline; none when the output ends, when we are
  /// interrupted, or when now_seconds() passes `deadline`.
  [[nodiscard]] std::optional<std::string> read_line(
      double deadline = std::numeric_limits<double>::infinity());

  /// Writes a line to its standard input.
  void write_line(const std::string& line);

  /// Waits for its end: a sentence about it, with what it wrote to standard error.
  [[nodiscard]] std::string how_it_ended();

 private:
  pid_t pid_ = -1;
  FileDescriptor input_, output_, errors_;
  std::string buffer_;
};

}  // namespace raysweep
