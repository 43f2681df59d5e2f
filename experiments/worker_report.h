// What each worker did, for whoever looks at one picture.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "results/tables/table.h"
#include "schedulers/worker_log.h"

namespace raysweep {

/// One row a worker: items and chunks of all runs together, times a run. The log must hold times.
[[nodiscard]] Table worker_table(const WorkerLog& log);

/// The same unrounded, as an array; times are sums in seconds.
[[nodiscard]] nlohmann::json workers_as_json(const WorkerLog& log);

}  // namespace raysweep
