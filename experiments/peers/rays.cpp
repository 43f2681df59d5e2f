#include "experiments/peers/rays.h"

#include <numbers>
#include <optional>

#include "results/statistics/random.h"
#include "tracer/scene/view.h"
#include "tracer/shade/phong.h"

namespace raysweep {

namespace {

struct LimitedRay {
  Ray<float> ray;
  float t_max = std::numeric_limits<float>::infinity();
};

/// From 0 to below 1, in steps that a float holds.
float uniform(Random& random) {
  constexpr size_t steps = size_t{1} << 24;
  return static_cast<float>(random.index(steps)) / static_cast<float>(steps);
}

/// Uniform on the disc below, raised onto the hemisphere (Malley; pbrt-v4, A.5.3), around `normal` by the
/// frame of Duff et al. 2017, "Building an orthonormal basis, revisited".
Vec3f cosine_direction(const Vec3f& normal, Random& random) {
  const float r2 = uniform(random), angle = 2 * std::numbers::pi_v<float> * uniform(random);
  const float x = std::sqrt(r2) * std::cos(angle), y = std::sqrt(r2) * std::sin(angle);
  const float sign = std::copysign(1.0f, normal.z);
  const float a = -1 / (sign + normal.z), b = normal.x * normal.y * a;
  const Vec3f tangent(1 + sign * normal.x * normal.x * a, sign * b, -sign * normal.x);
  const Vec3f bitangent(b, sign + normal.y * normal.y * a, -normal.y);
  return normalize(tangent * x + bitangent * y + normal * std::sqrt(1 - r2));
}

std::optional<LimitedRay> towards_first_light(const Scene& scene, const Surface<float>& surface) {
  if (scene.lights.empty()) return std::nullopt;
  const Vec3f origin = surface.point + surface.normal * surface.clearance;
  const Vec3f towards = Vec3f(scene.lights.front().position) - origin;
  const float distance = length(towards);
  const Vec3f direction = towards * (1 / distance);
  if (!(distance > 0 && dot(surface.normal, direction) > 0)) return std::nullopt;
  return LimitedRay{spawn(surface, direction, true, surface.clearance), distance};
}

/// The ray of `kind` that follows the primary ray `ray`, if there is one.
std::optional<LimitedRay> follow(RayKind kind, const Scene& scene, const OracleCore& core,
                                 const Ray<float>& ray, Random& random) {
  if (kind == RayKind::primary) return LimitedRay{ray};
  const auto hit = core.closest(ray);
  if (!hit) return std::nullopt;
  const Surface<float> surface = core.primitives().surface(ray, *hit);
  if (kind == RayKind::shadow) return towards_first_light(scene, surface);
  const Vec3f direction = kind == RayKind::mirror ? normalize(reflect(ray.direction, surface.normal))
                                                  : cosine_direction(surface.normal, random);
  return LimitedRay{spawn(surface, direction, true, surface.clearance)};
}

/// Shows `visit` the upper left corner of each square of `side` in what is right of and below `from`, and
/// left of and above `to`, row by row.
template <class Visit>
void visit_squares(const PixelPlace& from, const PixelPlace& to, int side, Visit&& visit) {
  for (int y = from.y; y < to.y; y += side)
    for (int x = from.x; x < to.x; x += side) visit(PixelPlace{x, y});
}

}  // namespace

Scene triangles_alone(Scene scene) {
  scene.planes.clear();
  scene.spheres.clear();
  return scene;
}

std::vector<PixelPlace> pixels_in_blocks(int width, int height) {
  constexpr int tile = 16, block = 4;
  std::vector<PixelPlace> pixels;
  pixels.reserve(static_cast<size_t>(width) * static_cast<size_t>(height));
  const auto end_of = [&](const PixelPlace& from, int side) {
    return PixelPlace{std::min(from.x + side, width), std::min(from.y + side, height)};
  };
  visit_squares({0, 0}, {width, height}, tile, [&](const PixelPlace& of_tile) {
    visit_squares(of_tile, end_of(of_tile, tile), block, [&](const PixelPlace& of_block) {
      visit_squares(of_block, end_of(of_block, block), 1,
                    [&](const PixelPlace& pixel) { pixels.push_back(pixel); });
    });
  });
  return pixels;
}

RayBatch make_rays(RayKind kind, const Scene& scene, const OracleCore& core, int width, int height,
                   uint64_t seed) {
  Random random(seed);
  const View<float> view(scene.camera, width, height);
  std::vector<LimitedRay> rays;
  for (const PixelPlace& pixel : pixels_in_blocks(width, height)) {
    const Ray<float> primary =
        view.through(static_cast<float>(pixel.x) + 0.5f, static_cast<float>(pixel.y) + 0.5f);
    const auto ray = follow(kind, scene, core, primary, random);
    if (ray && is_finite(ray->ray) && !std::isnan(ray->t_max)) rays.push_back(*ray);
  }
  RayBatch batch(rays.size());
  for (size_t i = 0; i < rays.size(); ++i) batch.set(i, rays[i].ray, rays[i].t_max);
  return batch;
}

}  // namespace raysweep
