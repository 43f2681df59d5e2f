#include "schedulers/scheduler.h"

#include "schedulers/work.h"

namespace raysweep {

void Scheduler::run(const ItemSpace& items, const Chunk& chunk, const Body& body, WorkerLog& log) {
  if (items.count == 0) return;
  FirstError error;
  log.begin_run();
  run_items(items, chunk, Work(body, log, error));
  log.end_run();
  error.rethrow();
}

}  // namespace raysweep
