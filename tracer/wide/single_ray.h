// One ray at a time through a wide tree, without vectors of any instruction set: for rays that kernels leave
// over, and for those that ask for more than the nearest hit.
#pragma once

#include <array>

#include "tracer/wide/geometry.h"

namespace raysweep {

/// Where a ray is inside the boxes of a node's children, by `slab`.
template <int width>
struct ChildIntervals {
  std::array<float, width> enter, leave;

  ChildIntervals(const WideNode<width>& node, const SlabRay<float>& ray, float t_min) {
    for (size_t i = 0; i < width; ++i) {
      Box<float> box;
      box.bounds[0] = {node.bounds[0][0][i], node.bounds[1][0][i], node.bounds[2][0][i]};
      box.bounds[1] = {node.bounds[0][1][i], node.bounds[1][1][i], node.bounds[2][1][i]};
      const Interval<float> inside = slab(box, ray, t_min);
      enter[i] = inside.enter;
      leave[i] = inside.leave;
    }
  }
};

/// Shows `visit(block, lane, limit)` every primitive whose boxes the ray is inside of at `t_min ≤ t ≤ limit`,
/// roughly near to far; `visit` may lower `limit`. Stops and returns true when `visit` does.
template <class Method, int width, class Visit>
bool traverse(const WideGeometry<Method, width>& geometry, const SlabRay<float>& ray, float t_min,
              float limit, Visit&& visit) {
  struct Entry {
    WideChild child;
    float enter;
  };
  std::array<Entry, (width - 1) * max_hierarchy_depth + 2> stack;
  size_t top = 0;
  stack[top++] = {0, t_min};
  const int octant = ray.negative_x + 2 * ray.negative_y + 4 * ray.negative_z;
  while (top > 0) {
    const Entry entry = stack[--top];
    if (entry.enter > limit) continue;
    if ((entry.child & leaf_bit) != 0) {
      for (size_t b = child_index(entry.child);; ++b) {
        const auto& block = geometry.blocks[b];
        for (size_t lane = 0; lane < block.count; ++lane) {
          if (visit(block, lane, limit)) return true;
        }
        if (block.more == 0) break;
      }
      continue;
    }
    const WideNode<width>& node = geometry.tree.nodes[entry.child];
    if constexpr (requires { Method::visit_node(); }) Method::visit_node();
    const ChildIntervals<width> in(node, ray, t_min);
    for (size_t i = 0; i < width; ++i) {
      const size_t child = (node.far_to_near[octant] >> (i * WideNode<width>::order_bits)) & (width - 1);
      // Equal distances are visited: the lower id may be in there.
      if (in.enter[child] <= in.leave[child] && in.enter[child] <= limit)
        stack[top++] = {node.children[child], in.enter[child]};
    }
  }
  return false;
}

/// The distance to the primitive in `lane`, if it comes after `after`.
template <class Method, int width>
[[nodiscard]] std::optional<float> distance_to(const Primitives<float, Method>& primitives,
                                               const WideBlock<width>& block, size_t lane,
                                               const Ray<float>& ray, const SlabRay<float>& slab_ray,
                                               const Hit<float>& after) {
  const uint32_t id = block.id[lane];
  if (id < primitives.first_triangle()) return primitives.intersect_sphere(id, ray, slab_ray, after);
  // The block's corners are at hand, the primitives' are not.
  const auto corner = [&](size_t row) {
    return Vec3f(block.corners[row][lane], block.corners[row + 1][lane], block.corners[row + 2][lane]);
  };
  const auto prepared = Method::template prepare<float>({corner(0), corner(3), corner(6)});
  return primitives.intersect_triangle(id, prepared, ray, slab_ray, after);
}

template <class Method, int width>
[[nodiscard]] std::optional<Hit<float>> closest_hit(const WideGeometry<Method, width>& geometry,
                                                    const Ray<float>& ray, const Hit<float>& after,
                                                    float t_max) {
  if (!is_finite(ray)) return std::nullopt;
  const Primitives<float, Method>& primitives = *geometry.primitives;
  Hit<float> nearest = Hit<float>::none(t_max);
  const auto keep = [&](std::optional<float> t, uint32_t id) {
    if (t && Hit<float>{*t, id}.before(nearest)) nearest = {*t, id};
  };
  for (uint32_t id = 0; id < primitives.first_sphere(); ++id)
    keep(primitives.intersect_plane(id, ray, after), id);
  const SlabRay<float> slab_ray(ray);
  traverse(geometry, slab_ray, after.t, nearest.t, [&](const auto& block, size_t lane, float& limit) {
    keep(distance_to(primitives, block, lane, ray, slab_ray, after), block.id[lane]);
    limit = nearest.t;
    return false;
  });
  if (nearest.is_none()) return std::nullopt;
  return nearest;
}

/// As ScalarCore::visit_hits, but what lies in several leaves may be shown as often.
template <class Method, int width, class Visit>
bool visit_in_leaves(const WideGeometry<Method, width>& geometry, const Ray<float>& ray, float t_max,
                     Visit&& visit) {
  if (!is_finite(ray)) return false;
  const Primitives<float, Method>& primitives = *geometry.primitives;
  const auto visit_each = [&](uint32_t id, auto&& next_after) {
    Hit<float> last = Hit<float>::start();
    while (const std::optional<float> t = next_after(last)) {
      if (!(*t < t_max)) return false;
      last = {*t, id};
      if (visit(last)) return true;
      if (!primitives.is_met_twice(id)) return false;
    }
    return false;
  };
  for (uint32_t id = 0; id < primitives.first_sphere(); ++id) {
    if (visit_each(id, [&](const Hit<float>& last) { return primitives.intersect_plane(id, ray, last); }))
      return true;
  }
  const SlabRay<float> slab_ray(ray);
  return traverse(geometry, slab_ray, 0, t_max, [&](const auto& block, size_t lane, float&) {
    return visit_each(block.id[lane], [&](const Hit<float>& last) {
      return distance_to(primitives, block, lane, ray, slab_ray, last);
    });
  });
}

}  // namespace raysweep
