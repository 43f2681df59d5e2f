// The plain good core: flat nodes, nearer child first, nothing visited behind the nearest hit. The oracle of
// faster ones.
#pragma once

#include <array>

#include "tracer/accel/build_by_name.h"
#include "tracer/accel/primitives.h"

namespace raysweep {

template <class T, class Method>
class ScalarCore {
 public:
  using Real = T;
  using Shapes = Primitives<T, Method, TrianglesAtHand<T>>;

  ScalarCore(const Scene& scene, const std::string& accel, int leaf_size) : primitives_(scene) {
    const UnsetVector<Box<T>> boxes = primitives_.boxes();
    tree_ = build_by_name<T>(accel, boxes, primitives_.sphere_count(), leaf_size);
    is_cut_ = tree_.order.size() > boxes.size();
    const uint32_t base = primitives_.first_sphere();
    if (tree_.nodes.empty()) {
      for (uint32_t id = base; id < primitives_.count(); ++id) leaf_items_.push_back(make_item(id));
    }
    for (const uint32_t i : tree_.order) leaf_items_.push_back(make_item(base + i));
  }

  [[nodiscard]] const Shapes& primitives() const { return primitives_; }
  [[nodiscard]] const Hierarchy<T>& tree() const { return tree_; }

  /// The first hit after `after` with t ≤ `t_max`. A ray with a number that is not finite hits nothing.
  [[nodiscard]] std::optional<Hit<T>> closest(const Ray<T>& ray, const Hit<T>& after = Hit<T>::start(),
                                              T t_max = std::numeric_limits<T>::infinity()) const {
    if (!is_finite(ray)) return std::nullopt;
    Hit<T> nearest = Hit<T>::none(t_max);
    for (uint32_t id = 0; id < primitives_.first_sphere(); ++id) {
      if (const auto t = primitives_.intersect_plane(id, ray, after)) keep_nearer(nearest, {*t, id});
    }
    const SlabRay<T> slab_ray(ray);
    traverse(slab_ray, after.t, nearest.t, [&](const Item& item, T& limit) {
      if (const auto t = intersect(item, ray, slab_ray, after)) {
        keep_nearer(nearest, {*t, item.id});
        limit = nearest.t;
      }
      return false;
    });
    if (nearest.is_none()) return std::nullopt;
    return nearest;
  }

  /// Whether anything is hit with 0 < t < t_max.
  [[nodiscard]] bool occluded(const Ray<T>& ray, T t_max) const {
    return visit_in_leaves(ray, t_max, [](const Hit<T>&) { return true; });
  }

  /// Shows `visit` hits with 0 < t < t_max, in no particular order, each once, until it returns true; whether
  /// it did.
  template <class Visit>
  bool visit_hits(const Ray<T>& ray, T t_max, Visit&& visit) const {
    return is_cut_ ? visit_in_order(*this, ray, t_max, visit) : visit_in_leaves(ray, t_max, visit);
  }

 private:
  /// As `visit_hits`, but what lies in several leaves may be shown as often.
  template <class Visit>
  bool visit_in_leaves(const Ray<T>& ray, T t_max, Visit&& visit) const {
    if (!is_finite(ray)) return false;
    const auto visit_all = [&](uint32_t id, auto&& intersect_after) {
      Hit<T> last = Hit<T>::start();
      while (const auto t = intersect_after(last)) {
        if (!(*t < t_max)) return false;
        last = {*t, id};
        if (visit(last)) return true;
        if (!primitives_.is_met_twice(id)) return false;
      }
      return false;
    };
    for (uint32_t id = 0; id < primitives_.first_sphere(); ++id) {
      if (visit_all(id, [&](const Hit<T>& last) { return primitives_.intersect_plane(id, ray, last); }))
        return true;
    }
    const SlabRay<T> slab_ray(ray);
    return traverse(slab_ray, T(0), t_max, [&](const Item& item, T&) {
      return visit_all(item.id, [&](const Hit<T>& last) { return intersect(item, ray, slab_ray, last); });
    });
  }

  /// A primitive with its data at hand, in the order in which leaves are read; spheres leave `prepared`
  /// empty.
  struct Item {
    typename Shapes::Prepared prepared;
    uint32_t id;
  };

  [[nodiscard]] Item make_item(uint32_t id) const {
    if (id < primitives_.first_triangle()) return {{}, id};
    return {primitives_.triangle(id), id};
  }

  static void keep_nearer(Hit<T>& nearest, const Hit<T>& hit) {
    if (hit.before(nearest)) nearest = hit;
  }

  [[nodiscard]] std::optional<T> intersect(const Item& item, const Ray<T>& ray, const SlabRay<T>& slab_ray,
                                           const Hit<T>& after) const {
    if (item.id < primitives_.first_triangle())
      return primitives_.intersect_sphere(item.id, ray, slab_ray, after);
    return primitives_.intersect_triangle(item.id, item.prepared, ray, slab_ray, after);
  }

  /// Shows `visit(item, limit)` every item whose boxes the ray is inside of at `t_min ≤ t ≤ limit`, roughly
  /// near to far; `visit` may lower `limit`. Stops and returns true when `visit` does.
  template <class Visit>
  bool traverse(const SlabRay<T>& slab_ray, T t_min, T limit, Visit&& visit) const {
    const auto visit_range = [&](uint32_t first, uint32_t count) {
      for (uint32_t i = first; i < first + count; ++i) {
        if (visit(leaf_items_[i], limit)) return true;
      }
      return false;
    };
    if (tree_.nodes.empty()) return visit_range(0, static_cast<uint32_t>(leaf_items_.size()));
    const Node<T>* const nodes = tree_.nodes.data();
    // Equal distances are visited: the lower id may be in there.
    const auto worth = [&](const Interval<T>& inside) { return !inside.empty() && inside.enter <= limit; };
    struct Entry {
      uint32_t node;
      T enter;
    };
    std::array<Entry, max_hierarchy_depth> stack;
    size_t top = 0;
    if (const Interval<T> inside = slab(nodes[0].box, slab_ray, t_min); worth(inside))
      stack[top++] = {0, inside.enter};
    while (top > 0) {
      const Entry entry = stack[--top];
      if (entry.enter > limit) continue;
      uint32_t current = entry.node;
      while (!nodes[current].is_leaf()) {
        if constexpr (requires { Method::visit_node(); }) Method::visit_node();
        const uint32_t left = nodes[current].first;
        const Interval<T> a = slab(nodes[left].box, slab_ray, t_min),
                          b = slab(nodes[left + 1].box, slab_ray, t_min);
        const bool in_a = worth(a), in_b = worth(b);
        if (in_a && in_b) {
          const bool a_first = a.enter <= b.enter;
          stack[top++] = a_first ? Entry{left + 1, b.enter} : Entry{left, a.enter};
          current = a_first ? left : left + 1;
        } else if (in_a || in_b) {
          current = in_a ? left : left + 1;
        } else {
          current = no_node;
          break;
        }
      }
      if (current != no_node && visit_range(nodes[current].first, nodes[current].count)) return true;
    }
    return false;
  }

  static constexpr uint32_t no_node = ~0u;

  Shapes primitives_;
  Hierarchy<T> tree_;
  std::vector<Item> leaf_items_;
  bool is_cut_;  // items lie in several leaves
};

}  // namespace raysweep
