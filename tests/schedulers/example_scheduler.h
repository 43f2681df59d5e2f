// The scheduler that schedulers/README.md writes. Not in the registry: an example, not a subject.
#pragma once

#include <memory>

#include "schedulers/options.h"
#include "schedulers/scheduler.h"

namespace raysweep {

std::unique_ptr<Scheduler> make_both_ends(const SchedulerOptions& options);

}  // namespace raysweep
