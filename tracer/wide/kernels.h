// Traversal of batches of rays, compiled once for every instruction set that the library can choose at run
// time.
#pragma once

#include <cstddef>
#include <memory>
#include <string_view>
#include <vector>

#include "tracer/intersect/moller_trumbore.h"
#include "tracer/intersect/morozov.h"
#include "tracer/intersect/woop_watertight.h"
#include "tracer/wide/geometry.h"
#include "tracer/wide/group_choice.h"
#include "tracer/wide/visit_counts.h"

namespace raysweep {

/// Memory that kernels work in; one for each thread, kept from batch to batch.
class KernelScratch {
 public:
  /// At least `bytes` that begin a cache line; what they held is lost.
  [[nodiscard]] void* reserve(size_t bytes) {
    if (bytes > size_) {
      memory_.reset(static_cast<std::byte*>(::operator new (bytes, std::align_val_t{64})));
      size_ = bytes;
    }
    return memory_.get();
  }

  /// Tells whether the rays that ask for the nearest hit are the camera's, level 1, or mirrored ones.
  void begin_level(int level) { nearest_ = level > 1 ? 1 : 0; }
  /// How rays that ask for any hit, or for the nearest, are grouped.
  [[nodiscard]] GroupChoice& choice(bool any) { return choices_[any ? 2 : nearest_]; }

  /// Rays of the last batch that the kernel left to exact traversal.
  std::vector<uint32_t> left_over;
  /// First rays of the groups of `packet_size` that were traced one ray at a time.
  std::vector<uint32_t> groups;
  /// Those of them that hold flat rays.
  std::vector<uint32_t> flat_groups;
  /// Of all batches so far.
  [[no_unique_address]] VisitCounts visits;

 private:
  struct Delete {
    void operator()(std::byte* memory) const { ::operator delete (memory, std::align_val_t{64}); }
  };
  std::unique_ptr<std::byte, Delete> memory_;
  size_t size_ = 0;
  GroupChoice choices_[3];
  size_t nearest_ = 0;
};

/// For each ray the nearest hit before the one that `hits` holds already (a distance with no id is a limit),
/// or, of the kernel `any`, some hit nearer than that distance. Where the geometry begins hits, what they
/// hold is lost: a ray's `t_max` is its limit. Rays with an origin or a direction beyond 2^60, with numbers
/// that are not finite, or flat ones that move too far along a flat axis are listed in `scratch.left_over`
/// and keep their hits.
template <class Method, int width>
using BatchKernel = void (*)(const WideGeometry<Method, width>& geometry, const RayBatch& rays,
                             HitBatch& hits, KernelScratch& scratch);

template <class Method, int width>
struct BatchKernels {
  struct Pair {
    BatchKernel<Method, width> closest = nullptr, any = nullptr;
  };
  Pair single;   // every ray goes its own way
  Pair packets;  // neighbours go together as long as they go the same way
};

/// Null where this program or this machine has no such instruction set, or its vectors are of another width.
template <class Method, int width>
[[nodiscard]] BatchKernels<Method, width> kernels_for(std::string_view isa);

}  // namespace raysweep
