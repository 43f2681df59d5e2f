// The fast core: rays in batches through wide nodes, by kernels chosen at run time. Answers as the scalar
// core does, bit for bit, on every instruction set.
#pragma once

#include <algorithm>
#include <numeric>
#include <stdexcept>

#include "tracer/accel/build_by_name.h"
#include "tracer/wide/isa.h"
#include "tracer/wide/kernels.h"
#include "tracer/wide/single_ray.h"

namespace raysweep {

/// How the rays of a batch are traced; the answers are the same.
enum class Grouping {
  single,   // one at a time
  packets,  // neighbours together where they go the same way
};

template <class MethodType, int width>
class WideCore {
 public:
  using Real = float;
  using Method = MethodType;

  /// `isa` must run here and be `width` wide. `for_each` shares the work of building.
  WideCore(const Scene& scene, const std::string& accel, int leaf_size, std::string_view isa,
           const ForEach& for_each = one_after_the_other)
      : WideCore(scene, accel, leaf_size, isa, for_each, UnsetVector<Box<float>>()) {}
  WideCore(const WideCore&) = delete;  // the geometry points to the primitives
  WideCore& operator=(const WideCore&) = delete;

  [[nodiscard]] const Primitives<float, Method>& primitives() const { return primitives_; }

  /// The first hit after `after` with t ≤ `t_max`. A ray with a number that is not finite hits nothing.
  [[nodiscard]] std::optional<Hit<float>> closest(
      const Ray<float>& ray, const Hit<float>& after = Hit<float>::start(),
      float t_max = std::numeric_limits<float>::infinity()) const {
    return closest_hit(geometry_, ray, after, t_max);
  }
  /// Whether anything is hit with 0 < t < t_max.
  [[nodiscard]] bool occluded(const Ray<float>& ray, float t_max) const {
    return visit_in_leaves(geometry_, ray, t_max, [](const Hit<float>&) { return true; });
  }
  /// Shows `visit` hits with 0 < t < t_max, in no particular order, each once, until it returns true; whether
  /// it did.
  template <class Visit>
  bool visit_hits(const Ray<float>& ray, float t_max, Visit&& visit) const {
    return geometry_.tree.is_cut ? visit_in_order(*this, ray, t_max, visit)
                                 : visit_in_leaves(geometry_, ray, t_max, visit);
  }

  /// The first hit of each ray with 0 < t ≤ t_max.
  void closest(const RayBatch& rays, HitBatch& hits, KernelScratch& scratch,
               Grouping grouping = Grouping::packets) const {
    begin(rays, hits, [](const Hit<float>& hit, const Hit<float>& nearest) { return hit.before(nearest); });
    run(kernels(grouping).closest, rays, hits, scratch);
    for (const uint32_t i : scratch.left_over) {
      const auto hit = closest(rays.ray(i), Hit<float>::start(), rays.t_max[i]);
      hits.t[i] = hit ? hit->t : rays.t_max[i];
      hits.id[i] = hit ? hit->id : no_hit_id;
    }
  }

  /// For each ray some hit with 0 < t < t_max, if there is one.
  void occluded(const RayBatch& rays, HitBatch& hits, KernelScratch& scratch,
                Grouping grouping = Grouping::packets) const {
    begin(rays, hits, [](const Hit<float>& hit, const Hit<float>& nearest) { return hit.t < nearest.t; });
    run(kernels(grouping).any, rays, hits, scratch);
    for (const uint32_t i : scratch.left_over) {
      hits.t[i] = rays.t_max[i];
      hits.id[i] = no_hit_id;
      visit_in_leaves(geometry_, rays.ray(i), rays.t_max[i], [&](const Hit<float>& hit) {
        hits.t[i] = hit.t;
        hits.id[i] = hit.id;
        return true;
      });
    }
  }

 private:
  /// `boxes`: none, to begin with.
  WideCore(const Scene& scene, const std::string& accel, int leaf_size, std::string_view isa,
           const ForEach& for_each, UnsetVector<Box<float>> boxes)
      : primitives_(scene, for_each, &boxes),
        geometry_(primitives_, build(accel, leaf_size, boxes, for_each), for_each),
        kernels_(kernels_for<Method, width>(isa)) {
    if (!kernels_.single.closest) throw std::invalid_argument("no kernels for \"" + std::string(isa) + "\"");
    // Kernels may overflow with such boxes.
    const Box<float>& bounds = geometry_.tree.bounds;
    is_tame_ = std::max(max_abs(bounds.lower()), max_abs(bounds.upper())) <= 0x1p60f ||
               primitives_.count() == primitives_.first_sphere();
  }

  [[nodiscard]] WideTree<width> build(const std::string& accel, int leaf_size,
                                      std::span<const Box<float>> boxes, const ForEach& for_each) const {
    // The collapse decides itself what is a leaf, so it is handed small ones: to split those further takes
    // time and gains nothing. Others are studied for their leaves.
    constexpr int small_leaf = width - 1;
    const bool merges_leaves = accel == "sah" || accel == "sbvh";
    const Hierarchy<float> binary =
        build_by_name<float>(accel, boxes, primitives_.sphere_count(), merges_leaves ? small_leaf : leaf_size,
                             merges_leaves ? width : 1, for_each);
    return collapse<width>(binary, boxes, {primitives_.sphere_count(), merges_leaves}, for_each);
  }

  /// Planes have no boxes: each ray meets all of them first.
  template <class IsBefore>
  void begin(const RayBatch& rays, HitBatch& hits, IsBefore&& is_before) const {
    if (geometry_.begins_hits()) return;
    for (size_t i = 0; i < rays.size; ++i) {
      Hit<float> nearest = Hit<float>::none(rays.t_max[i]);
      for (uint32_t id = 0; id < primitives_.first_sphere(); ++id) {
        const auto t = primitives_.intersect_plane(id, rays.ray(i), Hit<float>::start());
        if (t && is_before(Hit<float>{*t, id}, nearest)) nearest = {*t, id};
      }
      hits.t[i] = nearest.t;
      hits.id[i] = nearest.id;
    }
  }

  [[nodiscard]] const auto& kernels(Grouping grouping) const {
    return grouping == Grouping::packets ? kernels_.packets : kernels_.single;
  }

  void run(BatchKernel<Method, width> kernel, const RayBatch& rays, HitBatch& hits,
           KernelScratch& scratch) const {
    if (is_tame_) return kernel(geometry_, rays, hits, scratch);
    scratch.left_over.resize(rays.size);
    std::iota(scratch.left_over.begin(), scratch.left_over.end(), 0u);
  }

  Primitives<float, Method> primitives_;
  WideGeometry<Method, width> geometry_;
  BatchKernels<Method, width> kernels_;
  bool is_tame_;
};

}  // namespace raysweep
