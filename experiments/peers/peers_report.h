// Comparisons with Embree, for people and for programs.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "experiments/peers/peers.h"
#include "results/tables/table.h"

namespace raysweep {

/// `{rows, pictures, builds}`.
[[nodiscard]] nlohmann::json to_json(const PeersResult& result);

/// Who is how fast on which rays; the caption says what is compared and how.
[[nodiscard]] Table rays_table(const PeersResult& result, const PeersRequest& request,
                               const EmbreeModule& embree);

/// Who makes whole pictures how fast, one row for each mode and count of threads.
[[nodiscard]] Table pictures_table(const PeersResult& result, const PeersRequest& request,
                                   const EmbreeModule& embree);

/// What building took.
[[nodiscard]] Table builds_table(const PeersResult& result);

}  // namespace raysweep
