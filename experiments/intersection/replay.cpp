#include "experiments/intersection/replay.h"

#include <array>

#include "tracer/scene/scenes.h"

namespace raysweep {

namespace {

using TreeNode = Node<float>;

/// Follows rays through the hierarchy of a core as that core does: the nearer child first, nothing visited
/// behind the nearest hit.
class Recorder {
 public:
  explicit Recorder(const OracleCore& core) : core_(core) {
    const uint32_t first = core.primitives().first_triangle();
    for (const uint32_t item : core.tree().order)
      work_.triangles.push_back(core.primitives().triangle_shape(first + item).corners);
  }

  void add(const Ray<float>& ray, float t_max, bool any_hit) {
    const SlabRay<float> slab_ray(ray);
    Hit<float> nearest = Hit<float>::none(t_max);
    const std::span<const TreeNode> nodes = core_.tree().nodes;
    struct Entry {
      uint32_t node;
      float enter;
    };
    std::array<Entry, max_hierarchy_depth> stack;
    size_t top = 0;
    const auto push = [&](uint32_t node, const Interval<float>& inside) {
      if (!inside.empty() && inside.enter <= nearest.t) stack[top++] = {node, inside.enter};
    };
    push(0, slab(nodes[0].box, slab_ray));
    while (top > 0) {
      const Entry entry = stack[--top];
      if (entry.enter > nearest.t) continue;
      const TreeNode& node = nodes[entry.node];
      if (node.is_leaf()) {
        visit(node, ray, slab_ray, nearest);
        if (any_hit && !nearest.is_none()) break;
        continue;
      }
      const Interval<float> a = slab(nodes[node.first].box, slab_ray),
                            b = slab(nodes[node.first + 1].box, slab_ray);
      const bool a_first = a.enter <= b.enter;
      push(a_first ? node.first + 1 : node.first, a_first ? b : a);
      push(a_first ? node.first : node.first + 1, a_first ? a : b);
    }
    work_.rays.push_back(ray);
  }

  [[nodiscard]] Workload<float> take() { return std::move(work_); }

 private:
  void visit(const TreeNode& leaf, const Ray<float>& ray, const SlabRay<float>& slab_ray,
             Hit<float>& nearest) {
    work_.visits.push_back({static_cast<uint32_t>(work_.rays.size()), leaf.first, leaf.count, nearest.t});
    const auto& shapes = core_.primitives();
    for (uint32_t i = leaf.first; i < leaf.first + leaf.count; ++i) {
      const uint32_t id = shapes.first_triangle() + core_.tree().order[i];
      const auto t = shapes.intersect_triangle(id, shapes.triangle(id), ray, slab_ray, Hit<float>::start());
      if (t && Hit<float>{*t, id}.before(nearest)) nearest = {*t, id};
    }
  }

  const OracleCore& core_;
  Workload<float> work_;
};

}  // namespace

Workload<float> record_replay(const Scene& scene, const OracleCore& core, const std::vector<RayKind>& kinds,
                              int width, int height, uint64_t seed) {
  Recorder recorder(core);
  for (const RayKind kind : kinds) {
    const RayBatch rays = make_rays(kind, scene, core, width, height, seed);
    for (size_t i = 0; i < rays.size; ++i) recorder.add(rays.ray(i), rays.t_max[i], asks_any_hit(kind));
  }
  return recorder.take();
}

Workload<float> replay_work(const std::string& name, uint64_t seed) {
  constexpr int width = 96, height = 72;  // three kinds of at most 6912 rays
  constexpr int leaf_size = 4;
  const Scene scene = triangles_alone(load_scene(name));
  const OracleCore core(scene, "sah", leaf_size);
  return record_replay(scene, core, {RayKind::primary, RayKind::shadow, RayKind::diffuse}, width, height,
                       seed);
}

}  // namespace raysweep
