#include "experiments/intersection/badness.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace raysweep {

namespace {

/// The weights of A, B and C.
using Weights = std::array<long double, 3>;

Weights weights_of(const ExactHit& exact) { return {1 - exact.beta - exact.gamma, exact.beta, exact.gamma}; }

/// How far inside, negative outside; NaN where the plane is not met.
long double depth_of(const ExactHit& exact) {
  const Weights w = weights_of(exact);
  return std::isnan(w[0]) ? w[0] : std::min({w[0], w[1], w[2]});
}

Badness wrong_by(bool is_wrong, long double how_much) {
  const double much = static_cast<double>(how_much);
  return {is_wrong, is_wrong ? much : -much};
}

Badness badness_of_miss(const ExactHit& exact, bool is_hit) {
  return exact.verdict == ExactVerdict::hit ? wrong_by(!is_hit, depth_of(exact)) : not_asked();
}

Badness badness_of_hit(const ExactHit& exact, bool is_hit) {
  // Behind the origin a miss has no edge that decides.
  const bool is_beside = exact.verdict == ExactVerdict::miss && exact.t > 0 && depth_of(exact) < 0;
  return is_beside ? wrong_by(is_hit, -depth_of(exact)) : not_asked();
}

/// Errors that are not finite count as infinite.
Badness error_badness(long double error) {
  return {error > 0 || std::isnan(error),
          std::isnan(error) ? std::numeric_limits<double>::infinity() : static_cast<double>(error)};
}

template <class T>
Badness badness_of_value(Wrong what, const ExactHit& exact, const TriangleHit<T>& hit) {
  constexpr long double epsilon = std::numeric_limits<T>::epsilon();
  if (what == Wrong::t_error) return error_badness(std::abs(hit.t - exact.t) / (epsilon * exact.t));
  const long double of_beta = std::abs(hit.beta - exact.beta), of_gamma = std::abs(hit.gamma - exact.gamma);
  return error_badness((std::isnan(of_gamma) ? of_gamma : std::max(of_gamma, of_beta)) / epsilon);
}

template <class T>
Vec3<T> corner(const Triangle<T>& triangle, size_t i) {
  return i == 0 ? triangle.a : i == 1 ? triangle.b : triangle.c;
}

template <class T>
bool has_corner(const Triangle<T>& triangle, const Vec3<T>& point) {
  return triangle.a == point || triangle.b == point || triangle.c == point;
}

/// How far from the edge shared with `other` the ray meets `triangle`; NaN outside and near the edge's ends.
template <class T>
long double depth_beside_edge(const ExactHit& exact, const Triangle<T>& triangle, const Triangle<T>& other) {
  constexpr long double from_ends = 1.0L / 16, none = std::numeric_limits<long double>::quiet_NaN();
  if (exact.verdict == ExactVerdict::miss) return none;
  const Weights weights = weights_of(exact);
  long double depth = none;
  size_t shared = 0;
  for (size_t i = 0; i < weights.size(); ++i) {
    if (!has_corner(other, corner(triangle, i))) {
      depth = weights[i];
    } else if (weights[i] < from_ends) {
      return none;
    } else {
      ++shared;
    }
  }
  return shared == 2 ? depth : none;
}

/// On which side of the shared edge `triangle` lies, as seen along the ray: its other corner's side of the
/// plane through the edge along the ray, a volume.
template <class T>
long double side_of(const Ray<T>& ray, const Triangle<T>& triangle, const Triangle<T>& other) {
  using Wide = Vec3<long double>;
  std::array<Vec3<T>, 2> edge;
  Vec3<T> apex = triangle.a;
  size_t shared = 0;
  for (const Vec3<T>& point : {triangle.a, triangle.b, triangle.c}) {
    if (!has_corner(other, point)) {
      apex = point;
    } else if (shared < edge.size()) {
      edge[shared++] = point;
    }
  }
  // From the lesser end to the greater one: the same for both triangles.
  const auto key = [](const Vec3<T>& v) { return std::array<T, 3>{v.x, v.y, v.z}; };
  if (key(edge[1]) < key(edge[0])) std::swap(edge[0], edge[1]);
  const Wide start(edge[0]), along = Wide(edge[1]) - start;
  return dot(cross(Wide(ray.direction), along), Wide(apex) - start);
}

template <class T>
Badness badness_of_leak(const Question<T>& question, const Hits<T>& hits) {
  const Triangle<T>&first = question.triangles[0], &second = question.triangles[1];
  // At a fold that the ray sees from the side it hits both triangles or none: no surface goes on there.
  const long double sides = side_of(question.ray, first, second) * side_of(question.ray, second, first);
  if (!(sides < 0)) return not_asked();
  const ExactHit of_first = exact_hit(question.ray, first), of_second = exact_hit(question.ray, second);
  // A ray in one of the planes is nobody's.
  if (std::isnan(of_first.t) || std::isnan(of_second.t)) return not_asked();
  const long double a = depth_beside_edge(of_first, first, second);
  const long double b = depth_beside_edge(of_second, second, first);
  const long double depth = std::fmax(a, b);
  return std::isnan(depth) ? not_asked() : wrong_by(!hits[0] && !hits[1], depth);
}

bool is_tame(const Ray<double>& ray, const Triangle<double>& triangle) {
  constexpr double largest = 8, least_distance = 0.25, least_edge = 0.25, least_sine = 0.125;
  const Vec3d ab = triangle.b - triangle.a, ac = triangle.c - triangle.a, normal = cross(ab, ac);
  const double edge = std::max({length(ab), length(ac), length(triangle.c - triangle.b)});
  const double speed = length(ray.direction), slope = std::abs(dot(ray.direction, normal));
  const double away = std::abs(dot(triangle.a - ray.origin, normal));
  return std::max({max_abs(ray.origin), max_abs(triangle.a), max_abs(triangle.b), max_abs(triangle.c)}) <=
             largest &&
         speed >= 0.5 && speed <= 2 && edge >= least_edge && length(normal) >= least_sine * edge * edge &&
         slope >= least_sine * speed * length(normal) && away * speed >= least_distance * slope;
}

}  // namespace

Badness not_asked() { return {false, -std::numeric_limits<double>::infinity()}; }

template <class T>
bool is_in(Domain domain, const Question<T>& question) {
  const auto is_finite_one = [&](const Triangle<T>& t) {
    return is_finite(question.ray) && all_finite(t.a) && all_finite(t.b) && all_finite(t.c);
  };
  const Ray<double> ray{Vec3d(question.ray.origin), Vec3d(question.ray.direction)};
  return std::all_of(question.triangles.begin(), question.triangles.end(), [&](const Triangle<T>& t) {
    return is_finite_one(t) && (domain == Domain::any || is_tame(ray, t.template as<double>()));
  });
}

template <class T>
Badness badness_of(Wrong what, const Question<T>& question, const Hits<T>& hits) {
  if (what == Wrong::leak) return badness_of_leak(question, hits);
  const ExactHit exact = exact_hit(question.ray, question.triangles[0]);
  if (what == Wrong::false_miss) return badness_of_miss(exact, hits[0].has_value());
  if (what == Wrong::false_hit) return badness_of_hit(exact, hits[0].has_value());
  const bool is_right = exact.verdict == ExactVerdict::hit && hits[0].has_value();
  return is_right ? badness_of_value(what, exact, *hits[0]) : not_asked();
}

template bool is_in(Domain, const Question<float>&);
template bool is_in(Domain, const Question<double>&);
template Badness badness_of(Wrong, const Question<float>&, const Hits<float>&);
template Badness badness_of(Wrong, const Question<double>&, const Hits<double>&);

}  // namespace raysweep
