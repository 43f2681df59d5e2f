#include "experiments/advise/hit_sample.h"

#include <algorithm>
#include <cmath>

#include "experiments/intersection/oracle.h"
#include "experiments/peers/rays.h"
#include "results/statistics/statistics.h"

namespace raysweep {

namespace {

constexpr double bad_share = 0.999;

Spread rising(const std::vector<double>& values) {
  return {quantile(values, 0.5), quantile(values, bad_share)};
}
Spread falling(const std::vector<double>& values) {
  return {quantile(values, 0.5), quantile(values, 1 - bad_share)};
}

std::vector<SampledHit> hits_of(const Scene& scene, const OracleCore& core, const SampleSize& size) {
  std::vector<SampledHit> hits;
  for (const RayKind kind : {RayKind::primary, RayKind::shadow, RayKind::mirror, RayKind::diffuse}) {
    const RayBatch rays = make_rays(kind, scene, core, size.width, size.height, size.seed);
    for (size_t i = 0; i < rays.size; ++i) {
      const auto hit = core.closest(rays.ray(i), Hit<float>::start(), rays.t_max[i]);
      if (hit && hit->id >= core.primitives().first_triangle())
        hits.push_back({rays.ray(i), core.primitives().triangle_shape(hit->id).corners});
    }
  }
  return hits;
}

}  // namespace

std::vector<std::vector<SampledHit>> sample_hits(const Scene& scene, const std::vector<SampleSize>& sizes) {
  std::vector<std::vector<SampledHit>> samples(sizes.size());
  if (scene.triangle_count() == 0) return samples;
  const OracleCore core = make_oracle(scene);
  for (size_t i = 0; i < sizes.size(); ++i) samples[i] = hits_of(scene, core, sizes[i]);
  return samples;
}

double scene_size(const Scene& scene) {
  Box<double> all;
  for (const Mesh& mesh : scene.meshes) all.include(bounds_of(mesh));
  return scene.triangle_count() == 0 ? 0 : length(all.size());
}

HitNumbers numbers_of(const std::vector<SampledHit>& hits) {
  if (hits.empty()) return {};
  std::vector<double> coordinate, distance, edge, thinness, cosine;
  for (const auto& [ray, triangle] : hits) {
    const Triangle<double> t = triangle.as<double>();
    const Vec3d normal = cross(t.b - t.a, t.c - t.a), direction(ray.direction);
    const double longest = std::max({length(t.b - t.a), length(t.c - t.b), length(t.a - t.c)});
    coordinate.push_back(std::max({max_abs(t.a), max_abs(t.b), max_abs(t.c), max_abs(Vec3d(ray.origin))}));
    distance.push_back(static_cast<double>(exact_hit(ray, triangle).t) * length(direction));
    edge.push_back(longest);
    thinness.push_back(length(normal) / (longest * longest));
    cosine.push_back(std::abs(dot(normal, direction)) / (length(normal) * length(direction)));
  }
  return {rising(coordinate), rising(distance), falling(edge), falling(thinness), falling(cosine)};
}

}  // namespace raysweep
