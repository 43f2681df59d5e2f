#include "experiments/intersection/draw.h"

#include <numbers>

namespace raysweep {

double uniform(Random& random) { return static_cast<double>(random.index(size_t{1} << 53)) * 0x1p-53; }

Vec3d point_in_ball(Random& random) {
  const auto coordinate = [&] { return 2 * uniform(random) - 1; };
  for (;;) {
    const double x = coordinate(), y = coordinate();
    const Vec3d point(x, y, coordinate());
    if (dot(point, point) <= 1) return point;
  }
}

Vec3d any_direction(Random& random) {
  for (;;) {
    const Vec3d point = point_in_ball(random);
    if (dot(point, point) > 0.01) return normalize(point);
  }
}

Vec3d any_tangent(const Vec3d& axis, Random& random) {
  for (;;) {
    const Vec3d across = cross(axis, any_direction(random));
    if (dot(across, across) > 0.01) return normalize(across);
  }
}

Triangle<double> plain_triangle(Random& random) {
  for (;;) {
    const Vec3d a = point_in_ball(random), b = point_in_ball(random), c = point_in_ball(random);
    if (length(cross(b - a, c - a)) >= 2 * 0.2) return {a, b, c};
  }
}

Vec3d view_of(const Vec3d& normal, double least, Random& random) {
  for (;;) {
    const Vec3d direction = any_direction(random);
    if (std::abs(dot(direction, normal)) >= least) return direction;
  }
}

Vec3d point_about(const Triangle<double>& t, Random& random) {
  double beta = uniform(random), gamma = uniform(random);
  if (random.index(4) == 0) {
    beta = 3 * beta - 1;
    gamma = 3 * gamma - 1;
  } else if (beta + gamma > 1) {
    beta = 1 - beta;
    gamma = 1 - gamma;
  }
  return t.a + (t.b - t.a) * beta + (t.c - t.a) * gamma;
}

Turn::Turn(double share) {
  // Reduced to an eighth of a turn around the nearest quarter, then by Taylor's series, whose next terms are
  // below 2⁻⁵³: 0.79¹⁸/18! and 0.79¹⁹/19!.
  const double quarters = std::floor(4 * share + 0.5);
  const double angle = 2 * std::numbers::pi * (share - quarters / 4), square = angle * angle;
  double c = 1, s = 1;
  for (int n = 16; n >= 2; n -= 2) {
    c = 1 - c * square / (n * (n - 1));
    s = 1 - s * square / (n * (n + 1));
  }
  s *= angle;
  const int quarter = static_cast<int>(quarters) & 3;
  cosine = quarter == 0 ? c : quarter == 1 ? -s : quarter == 2 ? -c : s;
  sine = quarter == 0 ? s : quarter == 1 ? c : quarter == 2 ? -s : -c;
}

}  // namespace raysweep
