// Starting the real program from tests.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <string>
#include <vector>

namespace raysweep {

struct ProgramResult {
  int exit_code;  // 128 + signal if one ended it
  std::string out, err;
};

/// A program that goes on while the test does.
class Program {
 public:
  /// `prepare` is called in the new process before it becomes the program.
  explicit Program(std::vector<std::string> arguments, void (*prepare)() = nullptr);
  ~Program();
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  [[nodiscard]] pid_t pid() const { return pid_; }
  void send(int signal) const;
  [[nodiscard]] ProgramResult wait();

 private:
  pid_t pid_ = -1;
  std::filesystem::path out_, err_;
};

/// Runs the program to its end.
[[nodiscard]] ProgramResult run_program(std::vector<std::string> arguments, void (*prepare)() = nullptr);

/// A folder of the test's own, gone with the object.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  [[nodiscard]] std::string file(const std::string& name) const { return (path_ / name).string(); }
  /// Writes a file and gives its path.
  [[nodiscard]] std::string write(const std::string& name, const std::string& text) const;
  /// How many files and folders are in it.
  [[nodiscard]] size_t entries() const;

 private:
  std::filesystem::path path_;
};

[[nodiscard]] std::string read_file(const std::string& file);

}  // namespace raysweep
