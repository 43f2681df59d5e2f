#include <algorithm>
#include <cmath>

#include "experiments/intersection/protocols.h"

namespace raysweep {

namespace {

double largest(const Vec3d& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

/// A number that has to be above 0 for a hit, and what rounding may do to it.
struct Claim {
  double value, blur;
};

}  // namespace

Clarity clarity_of(const Ray<float>& ray, const Triangle<float>& triangle, float t_max) {
  // In double its own rounding is 2⁻²⁹ of floats'.
  const Vec3d o(ray.origin), d(ray.direction), a(triangle.a), b(triangle.b), c(triangle.c);
  const Vec3d ab = b - a, ac = c - a, n = cross(ab, ac);
  const double twice_area = length(n), speed = length(d);
  const double cosine = std::abs(dot(n, d)) / (twice_area * speed);
  const double t = dot(n, a - o) / dot(n, d);
  const Vec3d p = o + d * t - a;
  const double beta = dot(n, cross(p, ac)) / dot(n, n), gamma = dot(n, cross(ab, p)) / dot(n, n);
  const double scale = std::max({largest(o), largest(a), largest(b), largest(c)}) + std::abs(t) * speed;
  const double blur = 0x1p-16 * scale / cosine;
  // A weight grows by 1 over an altitude, which is the doubled area by an edge.
  const auto weight_blur = [&](const Vec3d& edge) { return blur * length(edge) / twice_area; };
  const Claim claims[] = {{1 - beta - gamma, weight_blur(c - b)},
                          {beta, weight_blur(ac)},
                          {gamma, weight_blur(ab)},
                          {t, blur / speed},
                          {static_cast<double>(t_max) - t, blur / speed}};
  // NaN, of a triangle without area or a ray without direction, is neither.
  if (std::all_of(std::begin(claims), std::end(claims), [](const Claim& x) { return x.value > x.blur; }))
    return Clarity::hit;
  if (std::any_of(std::begin(claims), std::end(claims), [](const Claim& x) { return x.value < -x.blur; }))
    return Clarity::miss;
  return Clarity::unclear;
}

KnownHits known_hits(const Workload<float>& work) {
  KnownHits known;
  for (const Visit<float>& visit : work.visits) {
    for (uint32_t r = 0; r < work.rays_a_visit; ++r) {
      for (uint32_t i = 0; i < visit.triangle_count; ++i) {
        const Clarity clarity =
            clarity_of(work.rays[visit.first_ray + r], work.triangles[visit.first_triangle + i], visit.t_max);
        known.hits += clarity == Clarity::hit;
        known.unclear += clarity == Clarity::unclear;
      }
    }
  }
  return known;
}

}  // namespace raysweep
