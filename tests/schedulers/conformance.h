// What the conformance tests share: the registry as test parameters, bodies that wait for each other, and the
// claims that every maker of schedulers must fulfil, those outside the registry included.
#pragma once

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <functional>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "schedulers/registry.h"
#include "tests/schedulers/available.h"

namespace raysweep {

/// Makes a scheduler of so many threads.
using Factory = std::function<std::unique_ptr<Scheduler>(int threads)>;

/// Every item once, by a worker that there is, and the log counts the same, over threads, counts and chunks.
void expect_every_item_runs_exactly_once(const Factory& make, bool uses_threads = true);

/// Wherever the error comes from, it arrives after all workers stopped, and the next run works.
void expect_the_first_error_reaches_the_caller(const Factory& make);

class Conformance : public testing::TestWithParam<Tested> {
 public:
  [[nodiscard]] const std::string& name() const { return GetParam().scheduler; }
  [[nodiscard]] const SchedulerInfo& info() const { return *find_scheduler(name()); }
  [[nodiscard]] std::unique_ptr<Scheduler> make(SchedulerOptions options) const {
    options.runtime = GetParam().runtime;
    return make_scheduler(name(), options);
  }
  [[nodiscard]] std::unique_ptr<Scheduler> make(int threads) const {
    return make(SchedulerOptions{.threads = threads});
  }
  [[nodiscard]] Factory factory() const {
    return [this](int threads) { return make(threads); };
  }
  /// CTest gives each test a process of its own; whoever runs them all in one gets one OpenMP runtime.
  void SetUp() override {
    static std::string openmp;
    if (GetParam().runtime.empty()) return;
    if (openmp.empty()) openmp = GetParam().runtime;
    if (openmp != GetParam().runtime) GTEST_SKIP() << openmp << " is in this process already";
  }
  [[nodiscard]] int workers(int threads) const { return info().uses_threads ? threads : 1; }
};

/// Bodies that meet: each worker, at its first item, waits until all have come.
class Meeting {
 public:
  explicit Meeting(int workers) : here_(static_cast<size_t>(workers)) {}

  /// True if this is the worker's first item and all came; gives up after 20 s, lest a test hang.
  bool first_of(int worker) {
    if (here_[static_cast<size_t>(worker)].exchange(true)) return false;
    arrived_++;
    const auto give_up = std::chrono::steady_clock::now() + std::chrono::seconds(20);
    while (!complete() && std::chrono::steady_clock::now() < give_up) std::this_thread::yield();
    return complete();
  }
  [[nodiscard]] bool complete() const { return arrived_ >= here_.size(); }

 private:
  std::vector<std::atomic<bool>> here_;
  std::atomic<size_t> arrived_{0};
};

/// `usual`, but `sanitized` where each access to memory costs ten times as much.
template <class T>
constexpr T unless_sanitized([[maybe_unused]] T usual, [[maybe_unused]] T sanitized) {
#if defined(RAYSWEEP_TSAN) || defined(__SANITIZE_ADDRESS__)
  return sanitized;
#else
  return usual;
#endif
}

}  // namespace raysweep
