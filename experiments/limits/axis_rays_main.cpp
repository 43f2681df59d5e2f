// Case N5 of the failure catalogue: what rays along an axis cost in a mesh of axis-aligned boxes, and rays
// with subnormal components, against slanted ones. Tells times; a test counts the triangles tested.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <limits>
#include <random>

#include "tracer/accel/scalar.h"
#include "tracer/intersect/all.h"
#include "tracer/scene/shapes.h"
#include "tracer/wide/wide_core.h"

namespace raysweep {
namespace {

constexpr int side = 12;              // boxes along an axis
constexpr size_t ray_count = 30'000;  // as in bvh issue 21
constexpr int rounds = 7;

struct Kind {
  const char* name;
  Vec3f direction;
};
const Kind kinds[] = {{"slanted", normalize(Vec3f(0.01f, 0.02f, 1))},
                      {"along an axis", {0, 0, 1}},
                      {"one subnormal", {1e-40f, -0.0f, 1}},
                      {"two subnormal", {1e-40f, -3e-41f, 1}}};

Scene boxes() {
  Mesh mesh;
  for (int i = 0; i < side * side * side; ++i) {
    const int x = i % side, y = i / side % side, z = i / (side * side);
    const Vec3d lower(x, y, z);
    append_box(mesh, lower, lower + Vec3d(1, 1, 1));
  }
  Scene scene;
  scene.materials = {{}};
  scene.meshes = {mesh};
  return scene;
}

RayBatch rays_along(const Vec3f& direction) {
  std::mt19937 random(5);
  std::uniform_real_distribution<float> uniform(0, side);
  RayBatch rays(ray_count);
  for (size_t i = 0; i < ray_count; ++i) {
    const float x = uniform(random), y = uniform(random);
    rays.set(i, {{x, y, -1}, direction});
  }
  return rays;
}

double milliseconds() {
  using namespace std::chrono;
  return duration<double, std::milli>(steady_clock::now().time_since_epoch()).count();
}

/// The least of the rounds, all kinds in each. `trace(rays)` is what is timed.
template <class Trace>
void tell(std::string_view name, Trace&& trace) {
  double least[std::size(kinds)];
  std::ranges::fill(least, std::numeric_limits<double>::infinity());
  for (int round = 0; round < rounds; ++round) {
    for (size_t i = 0; i < std::size(kinds); ++i) {
      const RayBatch rays = rays_along(kinds[i].direction);
      const double start = milliseconds();
      trace(rays);
      least[i] = std::min(least[i], milliseconds() - start);
    }
  }
  for (size_t i = 0; i < std::size(kinds); ++i)
    fmt::print("{:<24} {:<14} {:7.2f} ms {:6.2f} times\n", name, kinds[i].name, least[i],
               least[i] / least[0]);
}

template <class Method>
void tell_method(const Scene& scene) {
  const ScalarCore<float, Method> scalar(scene, "sah", 4);
  tell(fmt::format("scalar {}", Method::name), [&](const RayBatch& rays) {
    for (size_t i = 0; i < rays.size; ++i) (void)scalar.closest(rays.ray(i));
  });
  const auto tell_wide = [&]<int width>(std::integral_constant<int, width>) {
    const WideCore<Method, width> wide(scene, "sah", 4, best_isa());
    tell(fmt::format("wide {}", Method::name), [&](const RayBatch& rays) {
      HitBatch hits(rays.size);
      KernelScratch scratch;
      wide.closest(rays, hits, scratch);
    });
  };
  const auto best = std::ranges::find_if(built_isas(), [](const Isa& isa) { return isa.name == best_isa(); });
  if (best->width == 4) {
    tell_wide(std::integral_constant<int, 4>());
  } else {
    tell_wide(std::integral_constant<int, 8>());
  }
}

}  // namespace
}  // namespace raysweep

int main() {
  const raysweep::Scene scene = raysweep::boxes();
  raysweep::for_each_method([&](auto method) { raysweep::tell_method<decltype(method)>(scene); });
}
