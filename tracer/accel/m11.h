// Morozov's own traversal (2011, 4.3.2), kept as an object of study: recursive over pointer nodes, both
// children always visited, no order, no cut behind the nearest hit, primitives behind virtual calls. Only
// shadow rays stop early, at the first occluder. What makes it slow is its subject; mend nothing here.
#pragma once

#include <memory>

#include "tracer/accel/build_by_name.h"
#include "tracer/accel/primitives.h"

namespace raysweep {

template <class T, class Method>
class M11Core {
 public:
  using Real = T;
  using Shapes = Primitives<T, Method, TrianglesAtHand<T>>;

  M11Core(const Scene& scene, const std::string& accel, int leaf_size) : primitives_(scene) {
    for (uint32_t id = 0; id < primitives_.first_sphere(); ++id) {
      unbounded_.push_back(std::make_unique<PlaneObject>(primitives_, id));
    }
    const UnsetVector<Box<T>> boxes = primitives_.boxes();
    const Hierarchy<T> tree = build_by_name<T>(accel, boxes, primitives_.sphere_count(), leaf_size);
    is_cut_ = tree.order.size() > boxes.size();
    if (!tree.nodes.empty()) {
      root_ = grow(tree, 0);
    } else {
      for (uint32_t id = primitives_.first_sphere(); id < primitives_.count(); ++id)
        unbounded_.push_back(make_object(id));
    }
  }

  M11Core(const M11Core&) = delete;  // objects point into it
  M11Core& operator=(const M11Core&) = delete;

  [[nodiscard]] const Shapes& primitives() const { return primitives_; }

  /// The first hit after `after` with t ≤ `t_max`. A ray with a number that is not finite hits nothing.
  [[nodiscard]] std::optional<Hit<T>> closest(const Ray<T>& ray, const Hit<T>& after = Hit<T>::start(),
                                              T t_max = std::numeric_limits<T>::infinity()) const {
    if (!is_finite(ray)) return std::nullopt;
    const Query query(ray, after);
    Hit<T> nearest = nearest_of(unbounded_, query);
    if (root_) {
      const Hit<T> inside = closest_in(*root_, query);
      if (inside.before(nearest)) nearest = inside;
    }
    if (!nearest.before(Hit<T>::none(t_max))) return std::nullopt;
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
    Query query(ray, Hit<T>::start());
    return visit_objects(unbounded_, query, t_max, visit) ||
           (root_ && visit_inside(*root_, query, t_max, visit));
  }

  struct Query {
    Query(const Ray<T>& asked, const Hit<T>& first) : ray(asked), slab_ray(asked), after(first) {}
    Ray<T> ray;
    SlabRay<T> slab_ray;
    Hit<T> after;
  };
  struct Object {
    Object(const Shapes& primitives, uint32_t number) : all(primitives), id(number) {}
    virtual ~Object() = default;
    [[nodiscard]] virtual std::optional<T> intersect(const Query& query) const = 0;
    const Shapes& all;
    const uint32_t id;
  };
  struct PlaneObject final : Object {
    using Object::Object;
    [[nodiscard]] std::optional<T> intersect(const Query& query) const override {
      return this->all.intersect_plane(this->id, query.ray, query.after);
    }
  };
  struct SphereObject final : Object {
    using Object::Object;
    [[nodiscard]] std::optional<T> intersect(const Query& query) const override {
      return this->all.intersect_sphere(this->id, query.ray, query.slab_ray, query.after);
    }
  };
  struct TriangleObject final : Object {
    TriangleObject(const Shapes& primitives, uint32_t number)
        : Object(primitives, number), prepared(primitives.triangle(number)) {}
    [[nodiscard]] std::optional<T> intersect(const Query& query) const override {
      return this->all.intersect_triangle(this->id, prepared, query.ray, query.slab_ray, query.after);
    }
    const typename Shapes::Prepared prepared;
  };
  using Objects = std::vector<std::unique_ptr<Object>>;

  struct TreeNode {
    Box<T> box;
    std::unique_ptr<TreeNode> left, right;
    Objects objects;  // of a leaf
  };

  [[nodiscard]] std::unique_ptr<Object> make_object(uint32_t id) const {
    if (id < primitives_.first_triangle()) return std::make_unique<SphereObject>(primitives_, id);
    return std::make_unique<TriangleObject>(primitives_, id);
  }

  [[nodiscard]] std::unique_ptr<TreeNode> grow(const Hierarchy<T>& tree, uint32_t index) const {
    const Node<T>& flat = tree.nodes[index];
    auto node = std::make_unique<TreeNode>();
    node->box = flat.box;
    if (flat.is_leaf()) {
      for (uint32_t i = flat.first; i < flat.first + flat.count; ++i) {
        node->objects.push_back(make_object(primitives_.first_sphere() + tree.order[i]));
      }
    } else {
      node->left = grow(tree, flat.first);
      node->right = grow(tree, flat.first + 1);
    }
    return node;
  }

  static Hit<T> nearest_of(const Objects& objects, const Query& query) {
    Hit<T> nearest = Hit<T>::none();
    for (const auto& object : objects) {
      const auto t = object->intersect(query);
      if (t && Hit<T>{*t, object->id}.before(nearest)) nearest = {*t, object->id};
    }
    return nearest;
  }

  static Hit<T> closest_in(const TreeNode& node, const Query& query) {
    if (slab(node.box, query.slab_ray).empty()) return Hit<T>::none();
    if (!node.left) return nearest_of(node.objects, query);
    const Hit<T> left = closest_in(*node.left, query);
    const Hit<T> right = closest_in(*node.right, query);
    return right.before(left) ? right : left;
  }

  template <class Visit>
  bool visit_objects(const Objects& objects, Query& query, T t_max, const Visit& visit) const {
    for (const auto& object : objects) {
      query.after = Hit<T>::start();
      while (const auto t = object->intersect(query)) {
        if (!(*t < t_max)) break;
        query.after = {*t, object->id};
        if (visit(query.after)) return true;
        if (!primitives_.is_met_twice(object->id)) break;
      }
    }
    return false;
  }

  template <class Visit>
  bool visit_inside(const TreeNode& node, Query& query, T t_max, const Visit& visit) const {
    if (slab(node.box, query.slab_ray).empty()) return false;
    if (!node.left) return visit_objects(node.objects, query, t_max, visit);
    return visit_inside(*node.left, query, t_max, visit) || visit_inside(*node.right, query, t_max, visit);
  }

  Shapes primitives_;
  Objects unbounded_;
  std::unique_ptr<TreeNode> root_;
  bool is_cut_;  // items lie in several leaves
};

}  // namespace raysweep
