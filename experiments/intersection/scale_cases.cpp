#include <algorithm>

#include "experiments/intersection/draw.h"
#include "experiments/intersection/families.h"

namespace raysweep {

namespace {

/// A triangle of `size` and a ray that meets its plane at the world's origin after `distance`, a power of 2:
/// however small the triangle is, no rounding moves the ray past it.
template <class T>
void through_zero(Trials<T>& trials, double size, double distance, Random& random) {
  const Triangle<double> unit = plain_triangle(random);
  const Vec3<T> direction(view_of(normal_of(unit), 0.2, random));
  const Vec3d aim = point_about(unit, random);
  trials.add({-direction * static_cast<T>(distance), direction}, rounded<T>(moved(unit, -aim, size)));
}

template <class T>
void straight_down(Trials<T>& trials, double size, Random& random) {
  const T s = static_cast<T>(size);
  const Vec3d aim = point_about({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, random);
  trials.add({{static_cast<T>(aim.x) * s, static_cast<T>(aim.y) * s, 1}, {0, 0, -1}},
             {{0, 0, 0}, {s, 0, 0}, {0, s, 0}});
}

/// Triangle and distance of one size, whose powers overflow or underflow.
template <class T>
void self_similar(Trials<T>& trials, double size, Random& random) {
  const Triangle<double> unit = plain_triangle(random);
  const Vec3<T> direction(view_of(normal_of(unit), 0.2, random));
  const Vec3d aim = point_about(unit, random);
  const T distance = static_cast<T>(4 * size);
  trials.add({-direction * distance, direction}, rounded<T>(moved(unit, -aim, size)));
}

template <class T>
void far_origin(Trials<T>& trials, double offset, Random& random) {
  const Triangle<double> unit = plain_triangle(random), there = moved(unit, any_direction(random) * offset);
  const Vec3d target = point_about(there, random);
  const Vec3d from = target + view_of(normal_of(unit), 0.2, random) * 10.0;
  trials.add(aimed(Vec3<T>(from), Vec3<T>(target)), rounded<T>(there));
}

template <class T>
void long_ray(Trials<T>& trials, double t, Random& random) {
  const Triangle<double> unit = plain_triangle(random);
  const Vec3d view = view_of(normal_of(unit), 0.2, random), target = point_about(unit, random);
  const Vec3<T> origin(target - view * 4.0);
  trials.add({origin, (Vec3<T>(target) - origin) * static_cast<T>(1 / t)}, rounded<T>(unit));
}

/// Of a size on the way of T's exponents down to the smallest normal number, at 1, and on its digits to the
/// smallest number of all, at 2.
template <class T>
void near_underflow(Trials<T>& trials, double way, Random& random) {
  using Limits = std::numeric_limits<T>;
  const double exponent = Limits::min_exponent * std::min(way, 1.0) - Limits::digits * std::max(way - 1, 0.0);
  self_similar(trials, std::ldexp(1.0, static_cast<int>(exponent)), random);
}

}  // namespace

std::vector<Case> scale_cases() {
  const std::string_view size = "size of the triangle", ours = "this study";
  const std::vector<double> smaller{1, 1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-13, 1e-16, 1e-20};
  return {
      with_each({"S1",
                 "small triangle straight below: absolute tolerances",
                 "Moeller & Trumbore 1997, epsilon",
                 Expectation::decided,
                 size,
                 {1, 1e-1, 1e-2, 1e-3, 2e-4, 1e-5, 1e-6}},
                [](auto& trials, double s, Random& random) { straight_down(trials, s, random); }),
      with_each({"S2",
                 "tiny triangle at distance 1",
                 ours,
                 Expectation::decided,
                 size,
                 {1, 1e-2, 1e-4, 1e-6, 1e-7, 1e-8, 1e-10, 1e-12, 1e-14, 1e-16}},
                [](auto& trials, double s, Random& random) { through_zero(trials, s, 1, random); }),
      with_each({"S3",
                 "huge triangle, seen from as far",
                 ours,
                 Expectation::decided,
                 size,
                 {1, 1e4, 1e8, 1e10, 1e13, 1e16, 1e20}},
                [](auto& trials, double s, Random& random) { self_similar(trials, s, random); }),
      with_each({"S4", "tiny triangle, seen from as near", ours, Expectation::decided, size, smaller},
                [](auto& trials, double s, Random& random) { self_similar(trials, s, random); }),
      with_each({"F1",
                 "unit triangle far from the origin, seen from 10",
                 ours,
                 Expectation::decided,
                 "distance from the origin",
                 {1, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8}},
                [](auto& trials, double offset, Random& random) { far_origin(trials, offset, random); }),
      with_each({"E1",
                 "long ray: short direction",
                 ours,
                 Expectation::decided,
                 "t, about",
                 {1, 1e2, 1e4, 1e6, 1e8, 1e10}},
                [](auto& trials, double t, Random& random) { long_ray(trials, t, random); }),
      with_each({"E4",
                 "subnormal coordinates",
                 ours,
                 Expectation::decided,
                 "size on the way to 0: 1 the smallest normal number, 2 the smallest number",
                 {0.1, 0.2, 0.3, 0.4, 0.6, 0.8, 1, 1.2, 1.4, 1.6}},
                [](auto& trials, double way, Random& random) { near_underflow(trials, way, random); }),
  };
}

}  // namespace raysweep
