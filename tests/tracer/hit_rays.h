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

/// Counts its tests, and nodes: what a core visits.
struct CountingMethod : MollerTrumbore {
  static inline long tests = 0, nodes = 0;
  static void visit_node() { nodes++; }
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

/// Which pixels follow one another.
enum class PixelOrder {
  scattered,
  blocks,  // 4 × 4 of them, each at a random place
};

/// Places on a picture of 1024 × 768, at random.
template <class T>
class RandomPixels {
 public:
  RandomPixels(PixelOrder order, std::mt19937& random) : order_(order), random_(random) {}

  /// Whether `next` begins a new block; each scattered place is one.
  [[nodiscard]] bool begins_block() const { return order_ == PixelOrder::scattered || count_ % 16 == 0; }

  std::pair<T, T> next() {
    if (begins_block()) {
      x_ = uniform_(random_) * 1024;
      y_ = uniform_(random_) * 768;
      count_ = 0;
    }
    const auto i = static_cast<int>(count_++);
    return {x_ + static_cast<T>(i % 4), y_ + static_cast<T>(i / 4)};
  }

 private:
  PixelOrder order_;
  std::mt19937& random_;
  std::uniform_real_distribution<T> uniform_{0, 1};
  T x_ = 0, y_ = 0;
  unsigned count_ = 0;
};

/// `count` rays of `kind`: primary (random pixels), shadow (from primary hits to random lights), reflected
/// (mirrored at primary hits), random (any origin in the scene, any direction).
template <class T, class Core>
std::vector<TestRay<T>> make_rays(const Scene& scene, const Core& core, const std::string& kind, size_t count,
                                  PixelOrder order = PixelOrder::scattered) {
  constexpr T infinity = std::numeric_limits<T>::infinity();
  std::mt19937 random(42);
  std::uniform_real_distribution<T> uniform(0, 1);
  const View<T> view(scene.camera, 1024, 768);
  std::vector<TestRay<T>> rays;
  RandomPixels<T> pixels(order, random);
  size_t light = 0;
  while (rays.size() < count) {
    if (kind == "random") {
      const auto symmetric = [&] { return 2 * uniform(random) - 1; };
      const Vec3<T> origin(symmetric(), symmetric() + T(0.5), symmetric()),
          direction(symmetric(), symmetric(), symmetric());
      if (length(direction) > 0) rays.push_back({{origin, normalize(direction)}, infinity});
      continue;
    }
    if (pixels.begins_block() && !scene.lights.empty()) light = random() % scene.lights.size();
    const auto [x, y] = pixels.next();
    const Ray<T> primary = view.through(x, y);
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
      const Vec3<T> towards = Vec3<T>(scene.lights[light].position) - origin;
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
