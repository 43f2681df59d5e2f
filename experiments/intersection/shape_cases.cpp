#include "experiments/intersection/draw.h"
#include "experiments/intersection/families.h"

namespace raysweep {

namespace {

/// Along `along`, with the third corner `altitude` beside the edge of length 1.
Triangle<double> needle_of(double altitude, Random& random) {
  const Vec3d along = any_direction(random), across = any_tangent(along, random);
  return {{0, 0, 0}, along, along * uniform(random) + across * altitude};
}

/// A ray through the world's origin, where the triangle's plane is but for rounding.
template <class T>
void look_at(Trials<T>& trials, const Triangle<double>& triangle, const Vec3d& view, double distance,
             Random& random) {
  const Vec3<T> direction(view);
  const Vec3d aim = point_about(triangle, random);
  trials.add({-direction * static_cast<T>(distance), direction}, rounded<T>(moved(triangle, -aim)));
}

/// At `cosine` to the normal.
Vec3d grazing_view(const Triangle<double>& triangle, double cosine, Random& random) {
  const Vec3d normal = normal_of(triangle);
  const double side = random.sign();
  return any_tangent(normal, random) * std::sqrt(1 - cosine * cosine) + normal * (side * cosine);
}

template <class T>
void needle(Trials<T>& trials, double altitude, Random& random) {
  const Triangle<double> triangle = needle_of(altitude, random);
  look_at(trials, triangle, view_of(normal_of(triangle), 0.2, random), 8, random);
}

/// Corners of integers, so that no area is exactly none. Kind 0: two of them equal; 1: all; 2: on a line.
template <class T>
void degenerate(Trials<T>& trials, double kind, Random& random) {
  const auto corner = [&](size_t largest) {
    const auto n = [&] { return random.sign() * static_cast<double>(random.index(largest + 1)); };
    const double x = n(), y = n();
    return Vec3d(x, y, n());
  };
  const Vec3d a = corner(1000), step = corner(10);
  const Vec3d b = kind == 1 ? a : a + step, c = kind == 2 ? a + step * 3.0 : a;
  const Triangle<T> triangle = rounded<T>({a, b, c});
  const Vec3d target = a + (b - a) * (0.25 * static_cast<double>(random.index(5)));
  trials.add(aimed(Vec3<T>(target + any_direction(random) * 100.0), Vec3<T>(target)), triangle);
}

/// The ray of pbrt's bug, as it is; others meet the same line elsewhere. The numbers are floats.
template <class T>
void degenerate_of_pbrt(Trials<T>& trials, Random& random) {
  const auto corner = [](float y) { return Vec3<T>(T(-1113.45459f), T(y), T(-56.2431908f)); };
  const Triangle<T> triangle{corner(-79.049614f), corner(-87.0922699f), corner(-79.2090149f)};
  const Vec3<T> origin(T(-1081.47925f), T(99.9999542f), T(87.7701111f));
  if (trials.rays.empty()) {
    trials.add({origin, {T(-32.1072998f), T(-183.355865f), T(-144.607635f)}}, triangle, T(.9999f));
  } else {
    const Vec3<T> target = triangle.a + (triangle.b - triangle.a) * static_cast<T>(uniform(random));
    trials.add({origin, target - origin}, triangle);
  }
}

template <class T>
void any_degenerate(Trials<T>& trials, double kind, Random& random) {
  if (kind == 3) {
    degenerate_of_pbrt(trials, random);
  } else {
    degenerate(trials, kind, random);
  }
}

template <class T>
void grazing(Trials<T>& trials, double cosine, Random& random) {
  const Triangle<double> triangle = plain_triangle(random);
  look_at(trials, triangle, grazing_view(triangle, cosine, random), 8, random);
}

/// Edges of 11.15, 9.74 and 1.44, which the report gives to one digit, 0.52° from the ray.
template <class T>
void grazing_sliver(Trials<T>& trials, double distance, Random& random) {
  constexpr double ab = 11.15, ac = 9.74, bc = 1.44;
  constexpr double c_along = (ab * ab + ac * ac - bc * bc) / (2 * ab);
  const Vec3d along = any_direction(random), across = any_tangent(along, random);
  const Vec3d c = along * c_along + across * std::sqrt(ac * ac - c_along * c_along);
  const Triangle<double> triangle{{0, 0, 0}, along * ab, c};
  look_at(trials, triangle, grazing_view(triangle, Turn(0.52 / 360).sine, random), distance, random);
}

/// Integers that are exact in T: a plane spanned by two vectors, a triangle and a ray `height` steps above
/// it.
template <class T>
void in_plane(Trials<T>& trials, bool is_axis_aligned, double height, Random& random) {
  const auto n = [&](size_t largest) {
    return random.sign() * static_cast<double>(random.index(largest) + 1);
  };
  Vec3d u(n(20), 0, 0), v(0, n(20), 0), base{n(100), n(100), n(100)};
  if (!is_axis_aligned) {
    u = {n(20), n(20), n(20)};
    v = {n(20), n(20), n(20)};
  }
  const Vec3d normal = cross(u, v);
  if (dot(normal, normal) == 0) return;
  const auto at = [&](double x, double y) { return Vec3<T>(base + u * x + v * y); };
  const Triangle<T> triangle{at(0, 0), at(4, 0), at(0, 4)};
  const double x = n(8), y = n(8);
  if (x == 1 && y == 1) return;  // where the ray leads to
  const Vec3<T> origin = at(x, y) + Vec3<T>(normal * height);
  trials.add({origin, at(1, 1) - at(x, y)}, triangle);
}

/// Of the normal's components two are `apart` of each other: methods that drop the longest axis drop either,
/// and the triangle's shadow is as thin as it gets when the third is as long.
template <class T>
void even_normal(Trials<T>& trials, double apart, Random& random) {
  const double y = 1 + apart * (2 * uniform(random) - 1), z = 1 + apart * (2 * uniform(random) - 1);
  const Vec3d normal = normalize(Vec3d{random.sign(), random.sign() * y, random.sign() * z});
  const Vec3d u = any_tangent(normal, random), v = cross(normal, u);
  const Triangle<double> triangle{{0, 0, 0}, u, u * uniform(random) + v};
  look_at(trials, triangle, view_of(normal, 0.2, random), 8, random);
}

}  // namespace

std::vector<Case> shape_cases() {
  const std::string_view ours = "this study";
  return {
      with_each({"D1",
                 "needle, seen from 8",
                 ours,
                 Expectation::decided,
                 "altitude over an edge of 1",
                 {1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-8, 1e-10, 1e-12}},
                [](auto& trials, double altitude, Random& random) { needle(trials, altitude, random); }),
      with_each({"D2",
                 "triangle without area",
                 "pbrt-v4's tests, for kind 3",
                 Expectation::must_miss,
                 "kind: 0 two equal corners, 1 three, 2 on a line, 3 on a line in pbrt's bug",
                 {0, 1, 2, 3}},
                [](auto& trials, double kind, Random& random) { any_degenerate(trials, kind, random); }),
      with_each({"D3",
                 "grazing ray",
                 ours,
                 Expectation::decided,
                 "cosine to the normal",
                 {1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8}},
                [](auto& trials, double cosine, Random& random) { grazing(trials, cosine, random); }),
      with_each(
          {"D4",
           "sliver under a grazing ray",
           "Embree issue 387",
           Expectation::decided,
           "distance of the ray's origin",
           {8, 64, 512}},
          [](auto& trials, double distance, Random& random) { grazing_sliver(trials, distance, random); }),
      with_each({"D5",
                 "ray in the triangle's plane",
                 ours,
                 Expectation::must_miss,
                 "kind: 0 the plane is parallel to axes, 1 it is not",
                 {0, 1}},
                [](auto& trials, double kind, Random& random) { in_plane(trials, kind == 0, 0, random); }),
      with_each({"E5",
                 "normal whose longest component is not clear",
                 ours,
                 Expectation::decided,
                 "relative difference of the components",
                 {1e-1, 1e-2, 1e-4, 1e-7, 0}},
                [](auto& trials, double apart, Random& random) { even_normal(trials, apart, random); }),
      with_each({"N8",
                 "ray parallel to the triangle's plane",
                 "Morozov 2011, listing 1: a branch-free return",
                 Expectation::must_miss,
                 "kind: 0 the plane is parallel to axes, 1 it is not",
                 {0, 1}},
                [](auto& trials, double kind, Random& random) { in_plane(trials, kind == 0, 1, random); }),
  };
}

}  // namespace raysweep
