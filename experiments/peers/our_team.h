// Our own cores as contestants: the one place that knows which there are.
#pragma once

#include "experiments/peers/contestant.h"
#include "tracer/accel/scalar.h"
#include "tracer/intersect/moller_trumbore.h"

namespace raysweep {

/// Whose hits all others are held against.
using OracleCore = ScalarCore<float, MollerTrumbore>;

[[nodiscard]] OracleCore make_oracle(const Scene& scene);

[[nodiscard]] Team make_our_team(const Scene& scene);

}  // namespace raysweep
