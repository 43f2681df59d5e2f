// What a scheduler hands its chunks to: it calls the body, keeps the log, and stops errors.
#pragma once

#include <atomic>
#include <exception>
#include <mutex>

#include "schedulers/item_space.h"
#include "schedulers/worker_log.h"

namespace raysweep {

/// The first of several errors from several threads.
class FirstError {
 public:
  void capture() noexcept {
    const std::scoped_lock lock(mutex_);
    if (!error_) error_ = std::current_exception();
    // Relaxed: the flag only saves work; the error itself is read after all workers have been joined.
    raised_.store(true, std::memory_order_relaxed);
  }
  [[nodiscard]] bool raised() const noexcept { return raised_.load(std::memory_order_relaxed); }
  void rethrow() const {
    if (error_) std::rethrow_exception(error_);
  }

 private:
  std::atomic<bool> raised_{false};
  std::mutex mutex_;
  std::exception_ptr error_;
};

/// One run's work. Safe to call from several threads, each with a worker number of its own.
class Work {
 public:
  Work(const Body& body, WorkerLog& log, FirstError& error) : body_(body), log_(log), error_(error) {}

  /// A chunk: items begin … end − 1, of which there is one at least.
  void operator()(size_t begin, size_t end, int worker) const noexcept {
    if (error_.raised()) return;
    const Entered entered(*this);
    log_.begin_chunk(worker, begin, end - begin);
    call(begin, end, worker);
    log_.end_chunk(worker);
  }

  /// A chunk of a grid with `columns` items a row: rows × columns of it.
  struct Block {
    size_t first_row, last_row, first_column, last_column;  // the last ones are one past the end
  };
  void operator()(const Block& block, size_t columns, int worker) const noexcept;

  /// One item of a chunk whose borders only a library knows.
  void item(size_t i, int worker) const noexcept;

  /// Told by schedulers on a runtime that ThreadSanitizer cannot look into, before and after the run: see
  /// work.cpp.
  void before_all() const noexcept;
  void after_all() const noexcept;

 private:
  /// What one thread does between entering and leaving happens after before_all and before after_all.
  class Entered {
   public:
#ifdef RAYSWEEP_TSAN
    explicit Entered(const Work& work) noexcept;
    ~Entered();

   private:
    const Work& work_;
#else
    explicit Entered(const Work&) noexcept {}
#endif
  };

  void call(size_t begin, size_t end, int worker) const noexcept {
    try {
      body_(begin, end, worker);
    } catch (...) {
      error_.capture();
    }
  }

  const Body& body_;
  WorkerLog& log_;
  FirstError& error_;
};

}  // namespace raysweep
