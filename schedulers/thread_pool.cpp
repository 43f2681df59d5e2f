#include "schedulers/thread_pool.h"

namespace raysweep {

ThreadPool::ThreadPool(int threads) {
  try {
    for (int worker = 1; worker < threads; ++worker) helpers_.emplace_back([this, worker] { serve(worker); });
  } catch (...) {
    stop();  // the system has no more threads: those made so far must not outlive this object
    throw;
  }
}

ThreadPool::~ThreadPool() { stop(); }

void ThreadPool::stop() noexcept {
  stopping_.store(true, std::memory_order_relaxed);  // published by the release of round_ below
  round_.fetch_add(1, std::memory_order_release);
  round_.notify_all();
  for (std::thread& helper : helpers_) helper.join();
}

void ThreadPool::run(const std::function<void(int)>& work) {
  work_ = &work;
  busy_.store(static_cast<int>(helpers_.size()), std::memory_order_relaxed);
  round_.fetch_add(1, std::memory_order_release);  // publishes work_ and busy_ to the helpers' acquire
  round_.notify_all();
  work(0);
  // Acquire pairs with the helpers' release: all that they wrote is seen after this loop.
  for (int left; (left = busy_.load(std::memory_order_acquire)) > 0;)
    busy_.wait(left, std::memory_order_acquire);
}

void ThreadPool::serve(int worker) {
  for (unsigned seen = 0;; ++seen) {
    round_.wait(seen, std::memory_order_acquire);  // acquire: work_, busy_ and stopping_ of this round
    if (stopping_.load(std::memory_order_relaxed)) return;
    (*work_)(worker);
    if (busy_.fetch_sub(1, std::memory_order_acq_rel) == 1) busy_.notify_one();
  }
}

}  // namespace raysweep
