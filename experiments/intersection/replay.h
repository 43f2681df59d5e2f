// The tests that a hierarchy leaves of a scene's rays, recorded to be done again.
#pragma once

#include "experiments/intersection/protocols.h"
#include "experiments/peers/rays.h"

namespace raysweep {

/// Rays of `kind`, one for each pixel at most, through `core`, which must be of `scene`, a scene without
/// planes and spheres: each leaf that a ray visits is a visit, with the nearest hit so far, or the shadow
/// ray's length, as its t_max. Triangles stand in the order of the leaves.
[[nodiscard]] Workload<float> record_replay(const Scene& scene, const OracleCore& core,
                                            const std::vector<RayKind>& kinds, int width, int height,
                                            uint64_t seed);

/// Camera, shadow and bounced rays of a built-in scene: at most 20,736 in all, fewer where rays leave the
/// scene, of a hierarchy by the surface area heuristic with up to four triangles a leaf. Throws SceneError
/// for an unknown scene.
[[nodiscard]] Workload<float> replay_work(const std::string& scene, uint64_t seed);

}  // namespace raysweep
