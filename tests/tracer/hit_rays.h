// Rays as rendering sends them out, by kind, for comparing cores with brute force.
#pragma once

#include <random>
#include <string>
#include <vector>

#include "tracer/accel/scalar.h"
#include "tracer/intersect/moller_trumbore.h"
#include "tracer/scene/view.h"
#include "tracer/shade/phong.h"

namespace raysweep {

/// Counts its tests: what a core visits.
struct CountingMethod : MollerTrumbore {
  static inline long tests = 0;
  template <class T>
  static std::optional<TriangleHit<T>> intersect(const Ray<T>& ray, const Prepared<T>& triangle) {
    tests++;
    return MollerTrumbore::intersect(ray, triangle);
  }
};

template <class T>
struct TestRay {
  Ray<T> ray;
  T t_max;  // finite for shadow rays
};

/// `count` rays of `kind`: primary (random pixels), shadow (from primary hits to random lights), reflected
/// (mirrored at primary hits), random (any origin in the scene, any direction).
template <class T, class Core>
std::vector<TestRay<T>> make_rays(const Scene& scene, const Core& core, const std::string& kind,
                                  size_t count) {
  constexpr T infinity = std::numeric_limits<T>::infinity();
  std::mt19937 random(42);
  std::uniform_real_distribution<T> uniform(0, 1);
  const View<T> view(scene.camera, 1024, 768);
  std::vector<TestRay<T>> rays;
  while (rays.size() < count) {
    if (kind == "random") {
      const auto symmetric = [&] { return 2 * uniform(random) - 1; };
      const Vec3<T> origin(symmetric(), symmetric() + T(0.5), symmetric()),
          direction(symmetric(), symmetric(), symmetric());
      if (length(direction) > 0) rays.push_back({{origin, normalize(direction)}, infinity});
      continue;
    }
    const Ray<T> primary = view.through(uniform(random) * 1024, uniform(random) * 768);
    if (kind == "primary") {
      rays.push_back({primary, infinity});
      continue;
    }
    const auto hit = core.closest(primary);
    if (!hit) continue;
    const auto surface = core.primitives().surface(primary, *hit);
    const Vec3<T> origin = surface.point + surface.normal * (100 * std::numeric_limits<T>::epsilon());
    if (kind == "reflected") {
      rays.push_back({{origin, normalize(reflect(primary.direction, surface.normal))}, infinity});
    } else {
      const Vec3<T> towards = Vec3<T>(scene.lights[random() % scene.lights.size()].position) - origin;
      rays.push_back({{origin, normalize(towards)}, length(towards)});
    }
  }
  return rays;
}

/// Whether two cores answer a ray alike, bit for bit: same primitive, same distance; same shadow.
template <class T, class A, class B>
bool answers_agree(const A& a, const B& b, const TestRay<T>& test) {
  if (test.t_max < std::numeric_limits<T>::infinity())
    return a.occluded(test.ray, test.t_max) == b.occluded(test.ray, test.t_max);
  const auto hit_a = a.closest(test.ray), hit_b = b.closest(test.ray);
  if (!hit_a || !hit_b) return !hit_a == !hit_b;
  return hit_a->id == hit_b->id && hit_a->t == hit_b->t;
}

}  // namespace raysweep
