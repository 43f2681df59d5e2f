// The schedulers that need no module, each in the file of its name.
#pragma once

#include "schedulers/options.h"
#include "schedulers/scheduler.h"

namespace raysweep {

std::unique_ptr<Scheduler> make_serial(const SchedulerOptions& options);
std::unique_ptr<Scheduler> make_thread_static(const SchedulerOptions& options);
std::unique_ptr<Scheduler> make_thread_cyclic(const SchedulerOptions& options);
std::unique_ptr<Scheduler> make_thread_dynamic(const SchedulerOptions& options);
std::unique_ptr<Scheduler> make_thread_guided(const SchedulerOptions& options);
std::unique_ptr<Scheduler> make_thread_chunks(const SchedulerOptions& options);
std::unique_ptr<Scheduler> make_thread_spawn(const SchedulerOptions& options);
std::unique_ptr<Scheduler> make_thread_stealing(const SchedulerOptions& options);

}  // namespace raysweep
