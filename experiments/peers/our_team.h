// Our own cores as contestants: the one place that knows which there are.
#pragma once

#include "experiments/peers/contestant.h"
#include "tracer/accel/scalar.h"
#include "tracer/intersect/moller_trumbore.h"
#include "tracer/intersect/woop_watertight.h"

namespace raysweep {

/// Whose hits all others are held against; robust entrants against those of the robust one.
using OracleCore = ScalarCore<float, MollerTrumbore>;
using RobustOracleCore = ScalarCore<float, WoopWatertight>;

[[nodiscard]] OracleCore make_oracle(const Scene& scene);
[[nodiscard]] RobustOracleCore make_robust_oracle(const Scene& scene);

/// On every instruction set of width 8, else on the best of width 4, the fastest method and the watertight
/// one, which is robust, each over a hierarchy of usual and one of high quality, with single rays and with
/// packets; builds are shared by `share`. `scene` must outlive the team.
[[nodiscard]] Team make_our_team(const Scene& scene, ShareWork share);

}  // namespace raysweep
