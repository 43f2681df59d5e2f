// Progress of a picture that takes long.
#pragma once

#include <atomic>
#include <cstddef>
#include <thread>

namespace raysweep {

/// Shows on standard error how many of `total` items are done, from a thread of its own, until it goes away.
class RenderWatch {
 public:
  RenderWatch(size_t total, bool quiet);

  /// Where items are counted.
  [[nodiscard]] std::atomic<size_t>& done() { return done_; }

 private:
  void watch(const std::stop_token& stop, bool quiet) const;

  size_t total_;
  std::atomic<size_t> done_ = 0;
  std::jthread thread_;  // last: it uses the others
};

}  // namespace raysweep
