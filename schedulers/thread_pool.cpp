#include "schedulers/thread_pool.h"

#include <limits>
#include <set>

namespace raysweep {

namespace {

/// Looks before sleeping, by default: some ten microseconds, the cost of one sleep and wake-up. A worker that
/// waits longer than this wastes at most as much again (Karlin et al. 1990, competitive spinning).
constexpr long long usual_spin_count = 300;

long long spin_count(const SchedulerOptions& options) {
  if (options.spin_count) return *options.spin_count;
  switch (options.wait) {
    case WaitPolicy::active:
      return std::numeric_limits<long long>::max();
    case WaitPolicy::passive:
      return 0;
    case WaitPolicy::usual:
      break;
  }
  // With more threads than processors, whom we wait for may be waiting for the processor that we spin on.
  const std::set<int> placed(options.processors.begin(), options.processors.end());
  const size_t processors = placed.empty() ? allowed_processors().size() : placed.size();
  return static_cast<size_t>(options.threads) > processors ? 0 : usual_spin_count;
}

void pause() {
#if defined(__x86_64__)
  __builtin_ia32_pause();
#elif defined(__aarch64__)
  asm volatile("isb");  // `yield` does nothing on most Arm cores
#endif
}

}  // namespace

ThreadPool::ThreadPool(const SchedulerOptions& options)
    : spin_count_(spin_count(options)), binding_(options.processors), caller_(binding_, 0) {
  try {
    for (int worker = 1; worker < options.threads; ++worker)
      helpers_.emplace_back([this, worker] { serve(worker); });
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

template <class Ready>
void ThreadPool::spin_until(Ready ready) const {
  // Whom we wait for may share our processor, where the system has put us both: now and then it gets its
  // turn. Every microsecond or so, for a third of that.
  constexpr int pauses_a_yield = 32;
  for (long long i = 0; i < spin_count_ && !ready(); ++i) {
    if (i % pauses_a_yield == pauses_a_yield - 1) {
      std::this_thread::yield();
    } else {
      pause();
    }
  }
}

void ThreadPool::run(const std::function<void(int)>& work) {
  work_ = &work;
  busy_.store(static_cast<int>(helpers_.size()), std::memory_order_relaxed);
  round_.fetch_add(1, std::memory_order_release);  // publishes work_ and busy_ to the helpers' acquire
  round_.notify_all();
  work(0);
  // Relaxed: the loop below looks again, with acquire.
  spin_until([this] { return busy_.load(std::memory_order_relaxed) == 0; });
  // Acquire pairs with the helpers' release: all that they wrote is seen after this loop.
  for (int left; (left = busy_.load(std::memory_order_acquire)) > 0;)
    busy_.wait(left, std::memory_order_acquire);
}

void ThreadPool::serve(int worker) {
  binding_.bind(worker);
  for (unsigned seen = 0;; ++seen) {
    spin_until(
        [&] { return round_.load(std::memory_order_relaxed) != seen; });  // relaxed: `wait` looks again
    round_.wait(seen, std::memory_order_acquire);  // acquire: work_, busy_ and stopping_ of this round
    if (stopping_.load(std::memory_order_relaxed)) return;
    (*work_)(worker);
    if (busy_.fetch_sub(1, std::memory_order_acq_rel) == 1) busy_.notify_one();
  }
}

}  // namespace raysweep
