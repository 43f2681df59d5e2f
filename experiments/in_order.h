// Independent work by several threads, whose results are taken one after the other in the work's order.
#pragma once

#include <algorithm>
#include <condition_variable>
#include <exception>
#include <map>
#include <mutex>
#include <optional>
#include <thread>
#include <type_traits>
#include <vector>

namespace raysweep {

/// Calls `work(i)` for i from 0 to `count` − 1, each once, on `threads` threads, 1 or more, and here
/// `take(i, result)` with what it gave, in order of i, until `take` returns false. No thread begins what is
/// more than a few items a thread ahead of the first that is not taken, so that little is lost by stopping.
/// Returns when all threads have ended. What `work` or `take` throws is rethrown here; after the first error
/// nothing is begun or taken.
template <class Work, class Take>
class InOrder {
 public:
  using Result = std::invoke_result_t<Work&, size_t>;

  InOrder(size_t count, size_t threads, Work& work, Take& take)
      : count_(count), window_(4 * threads), work_(work), take_(take) {
    std::vector<std::jthread> workers;
    try {
      while (workers.size() < std::min(threads, count)) workers.emplace_back([this] { run(); });
    } catch (...) {  // the system has no more threads
      stop(std::current_exception());
    }
    take_all();
    workers.clear();  // joins
    if (error_) std::rethrow_exception(error_);
  }
  InOrder(const InOrder&) = delete;
  InOrder& operator=(const InOrder&) = delete;

 private:
  void run() {
    while (const std::optional<size_t> i = begin_next()) {
      try {
        Result result = work_(*i);
        const std::lock_guard lock(mutex_);
        done_.emplace(*i, std::move(result));
      } catch (...) {
        stop(std::current_exception());
      }
      changed_.notify_all();
    }
  }

  /// Waits until the next item is near enough; nothing when there is none.
  std::optional<size_t> begin_next() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return stopped_ || next_ == count_ || next_ < taken_ + window_; });
    if (stopped_ || next_ == count_) return std::nullopt;
    return next_++;
  }

  /// The result of the first item that is not taken; nothing after an error.
  std::optional<Result> wait_for_next() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return stopped_ || done_.contains(taken_); });
    if (stopped_) return std::nullopt;
    return std::move(done_.extract(taken_).mapped());
  }

  void take_all() {
    try {
      while (taken_ < count_) {
        std::optional<Result> result = wait_for_next();
        if (!result) return;
        if (!take_(taken_, std::move(*result))) return stop(nullptr);
        const std::lock_guard lock(mutex_);
        ++taken_;
        changed_.notify_all();
      }
    } catch (...) {
      stop(std::current_exception());
    }
  }

  void stop(std::exception_ptr error) {
    const std::lock_guard lock(mutex_);
    stopped_ = true;
    if (!error_) error_ = std::move(error);
    changed_.notify_all();
  }

  const size_t count_, window_;
  Work& work_;
  Take& take_;
  std::mutex
      mutex_;  // of all below; `taken_` is written by the constructor's thread alone, which may read it
  std::condition_variable changed_;
  size_t next_ = 0, taken_ = 0;
  std::map<size_t, Result> done_;  // and not taken yet
  bool stopped_ = false;
  std::exception_ptr error_;
};

/// As `InOrder` says.
template <class Work, class Take>
void work_in_order(size_t count, size_t threads, Work work, Take take) {
  InOrder<Work, Take>(count, threads, work, take);
}

}  // namespace raysweep
