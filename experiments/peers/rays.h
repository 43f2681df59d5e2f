// Rays as rendering a scene sends them out, by kind, as one batch.
#pragma once

#include <array>
#include <string_view>

#include "experiments/peers/our_team.h"

namespace raysweep {

/// `scene` without planes and spheres, which not every tracer has.
[[nodiscard]] Scene triangles_alone(Scene scene);

enum class RayKind { primary, shadow, mirror, diffuse };
inline constexpr std::array ray_kind_names{"primary", "shadow", "mirror", "diffuse"};

/// Shadow rays ask for any hit, all others for the nearest.
[[nodiscard]] constexpr bool asks_any_hit(RayKind kind) { return kind == RayKind::shadow; }

struct PixelPlace {
  int x, y;
};

/// All pixels of a picture, so that rays that follow each other are near each other: tiles of 16 × 16 row by
/// row, in them blocks of 4 × 4, which fill a packet of 16 rays each.
[[nodiscard]] std::vector<PixelPlace> pixels_in_blocks(int width, int height);

/// One ray for each pixel at most, in the order of `pixels_in_blocks`. Primary: through the pixel's centre.
/// All others start where the primary ray hits, by `spawn` as in rendering, and are left out where it hits
/// nothing. Shadow: towards the scene's first light, up to it, left out where that is behind the surface.
/// Mirror: reflected. Diffuse: into the hemisphere by Lambert's cosine, the same for the same seed.
/// Directions have length 1; rays that are not finite are left out.
[[nodiscard]] RayBatch make_rays(RayKind kind, const Scene& scene, const OracleCore& core, int width,
                                 int height, uint64_t seed);

}  // namespace raysweep
