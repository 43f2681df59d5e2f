#include "experiments/render_watch.h"

#include <chrono>
#include <condition_variable>
#include <limits>
#include <mutex>

#include "experiments/clock.h"
#include "experiments/progress.h"

namespace raysweep {

RenderWatch::RenderWatch(size_t total, bool quiet)
    : total_(total), thread_([this, quiet](const std::stop_token& stop) { watch(stop, quiet); }) {}

void RenderWatch::watch(const std::stop_token& stop, bool quiet) const {
  using namespace std::chrono_literals;
  // Progress counts in int; beyond that, and that is 2³¹ tiles, it is shown as a share of it.
  const size_t unit = total_ / std::numeric_limits<int>::max() + 1;
  const int total = static_cast<int>(total_ / unit);
  Progress progress("items", now_seconds(), std::numeric_limits<double>::infinity(), quiet);
  std::mutex mutex;
  std::condition_variable_any stopped;
  std::unique_lock lock(mutex);
  while (!stopped.wait_for(lock, stop, 1s, [] { return false; }) && !stop.stop_requested()) {
    const size_t done = done_.load(std::memory_order_relaxed);  // a number to look at
    progress.show(static_cast<int>(done / unit), total, now_seconds(), "rendering");
  }
}

}  // namespace raysweep
