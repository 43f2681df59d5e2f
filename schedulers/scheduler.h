// The contract: run every item once; an item writes only its own slot; return when all are done; rethrow the
// first error after all workers stopped.
#pragma once

#include <memory>

#include "schedulers/item_space.h"
#include "schedulers/worker_log.h"

namespace raysweep {

class Work;

/// A pool of workers and a way to share items among them. The constructor owns the pool; threads are warm
/// from the first run on. Of schedulers that bind the thread that made them, one at a time is meant to live:
/// it gives that thread its former processors back when it ends.
class Scheduler {
 public:
  virtual ~Scheduler() = default;

  /// Runs every item once. When a body throws, chunks not yet begun are dropped, and the first error is
  /// rethrown here after all workers stopped; the scheduler stays usable. Throws std::system_error if it
  /// makes threads in each run and the system has no more. To be called by the thread that made the
  /// scheduler.
  void run(const ItemSpace& items, const Chunk& chunk, const Body& body, WorkerLog& log);

 private:
  /// Hands each item to `work` once, in chunks. Whatever the body throws stops at `work`.
  virtual void run_items(const ItemSpace& items, const Chunk& chunk, const Work& work) = 0;
};

}  // namespace raysweep
