#include "experiments/peers/shared_work.h"

#include <utility>

namespace raysweep {

WorkTeam::WorkTeam(int threads) {
  try {
    for (int i = 1; i < threads; ++i) others_.emplace_back([this, i] { serve(static_cast<size_t>(i)); });
  } catch (...) {
    end();  // those that did start would be waited for in vain
    throw;
  }
}

WorkTeam::~WorkTeam() { end(); }

void WorkTeam::end() {
  {
    const std::scoped_lock lock(mutex_);
    ends_ = true;
  }
  wake_.notify_all();
}

void WorkTeam::run(size_t count, const Body& body) {
  Run run;
  {
    const std::scoped_lock lock(mutex_);
    next_.store(0, std::memory_order_relaxed);  // nobody is inside; who joins takes the lock
    run_ = run = {&body, count, run_.number + 1};
  }
  wake_.notify_all();
  take_items(run, 0);
  std::unique_lock lock(mutex_);
  run_.body = nullptr;  // who wakes up only now has nothing to do, and is not waited for
  left_.wait(lock, [this] { return inside_ == 0; });
  if (const std::exception_ptr error = std::exchange(error_, nullptr)) std::rethrow_exception(error);
}

void WorkTeam::serve(size_t worker) {
  std::unique_lock lock(mutex_);
  for (size_t last = 0;;) {
    wake_.wait(lock, [&] { return ends_ || (run_.body && run_.number != last); });
    if (ends_) return;
    const Run run = run_;
    last = run.number;
    ++inside_;
    lock.unlock();
    take_items(run, worker);
    lock.lock();
    if (--inside_ == 0) left_.notify_one();
  }
}

void WorkTeam::take_items(const Run& run, size_t worker) {
  try {
    // Relaxed: who gets which number is all that is asked; the lock orders what the bodies wrote.
    for (size_t i = next_.fetch_add(1, std::memory_order_relaxed); i < run.count;
         i = next_.fetch_add(1, std::memory_order_relaxed))
      (*run.body)(i, worker);
  } catch (...) {
    next_.store(run.count, std::memory_order_relaxed);
    const std::scoped_lock lock(mutex_);
    if (!error_) error_ = std::current_exception();
  }
}

void share_work(int threads, size_t count, const WorkTeam::Body& body) { WorkTeam(threads).run(count, body); }

}  // namespace raysweep
