#include "experiments/peers/shared_work.h"

#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace raysweep {

void share_work(int threads, size_t count, const std::function<void(size_t i, size_t worker)>& body) {
  std::atomic<size_t> next{0};
  std::mutex mutex;
  std::exception_ptr error;
  const auto work = [&](size_t worker) {
    try {
      // Relaxed: who gets which number is all that is asked.
      for (size_t i = next.fetch_add(1, std::memory_order_relaxed); i < count;
           i = next.fetch_add(1, std::memory_order_relaxed))
        body(i, worker);
    } catch (...) {
      next.store(count, std::memory_order_relaxed);
      const std::scoped_lock lock(mutex);
      if (!error) error = std::current_exception();
    }
  };
  std::vector<std::jthread> others;
  try {
    for (int i = 1; i < threads; ++i) others.emplace_back(work, static_cast<size_t>(i));
  } catch (...) {
    next.store(count, std::memory_order_relaxed);  // those that did start have nothing left to do
    throw;
  }
  work(0);
  others.clear();  // waits for them
  if (error) std::rethrow_exception(error);
}

}  // namespace raysweep
