#include "schedulers/scheduler.h"

#include "schedulers/work.h"

namespace raysweep {

namespace {

/// A run of the log, ended also when threads cannot be made.
class LoggedRun {
 public:
  explicit LoggedRun(WorkerLog& log) : log_(log) { log_.begin_run(); }
  ~LoggedRun() { log_.end_run(); }
  LoggedRun(const LoggedRun&) = delete;
  LoggedRun& operator=(const LoggedRun&) = delete;

 private:
  WorkerLog& log_;
};

}  // namespace

void Scheduler::run(const ItemSpace& items, const Chunk& chunk, const Body& body, WorkerLog& log) {
  if (items.count == 0) return;
  FirstError error;
  {
    const LoggedRun logged(log);
    run_items(items, chunk, Work(body, log, error));
  }
  error.rethrow();
}

}  // namespace raysweep
