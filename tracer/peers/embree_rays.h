// Batches of rays in Embree's own layouts, and the calls that trace them.
#pragma once

#include <memory>

#include "tracer/peers/embree_scene.h"
#include "tracer/ray_batch.h"

namespace raysweep {

/// Rays by packets of one width: all that tracing needs is laid out before, in the form that Embree likes
/// best, so that a timed `trace` is calls of Embree and nothing else.
class EmbreeRays {
 public:
  virtual ~EmbreeRays() = default;
  /// Lays the rays out: for their nearest hits, or, for `any_hit`, to know whether there is one. Throws
  /// std::invalid_argument for a ray that Embree does not take: one with a number that is not finite or
  /// beyond 1.8e18; builds of Embree with assertions would end the process.
  virtual void prepare(const RayBatch& rays, bool any_hit) = 0;
  /// Undoes what `trace` writes into the rays.
  virtual void reset() = 0;
  /// Traces every packet once; denormals are zero meanwhile. `coherent` is what Embree is told of the rays.
  virtual void trace(const EmbreeScene& scene, bool coherent) = 0;
  /// What the last `trace` found, in our ids; of rays that ask for any hit, which one is not told: the first
  /// triangle's id stands for all.
  [[nodiscard]] virtual HitBatch hits(const EmbreeScene& scene) const = 0;
};

/// `width` rays a packet: 1, 4, 8 or 16.
[[nodiscard]] std::unique_ptr<EmbreeRays> make_embree_rays(int width);

}  // namespace raysweep
