#include "experiments/intersection/draw.h"
#include "experiments/intersection/families.h"
#include "experiments/intersection/oracle.h"

namespace raysweep {

namespace {

template <class T>
constexpr double ulp = static_cast<double>(std::numeric_limits<T>::epsilon());

/// From a point of the triangle, rounded, after `ulps` along the normal, to either side.
template <class T>
void on_surface(Trials<T>& trials, double ulps, Random& random) {
  const Triangle<double> triangle = plain_triangle(random);
  const Vec3d normal = normal_of(triangle);
  const double side = random.sign();
  const Vec3<T> origin(point_about(triangle, random) + normal * (side * ulps * ulp<T>));
  trials.add({origin, Vec3<T>(view_of(normal, 0.1, random))}, rounded<T>(triangle));
}

template <class T>
Ray<T> meeting(const Triangle<double>& triangle, Random& random) {
  const Vec3d target = point_about(triangle, random);
  return aimed(Vec3<T>(target + view_of(normal_of(triangle), 0.2, random) * 4.0), Vec3<T>(target));
}

/// The ray ends `ulps` before or after the place where it meets the plane.
template <class T>
void end_at_hit(Trials<T>& trials, double ulps, Random& random) {
  const Triangle<double> triangle = plain_triangle(random);
  const Ray<T> ray = meeting<T>(triangle, random);
  const T t = static_cast<T>(exact_hit(ray, rounded<T>(triangle)).t);
  trials.add(ray, rounded<T>(triangle), t * static_cast<T>(1 + random.sign() * ulps * ulp<T>));
}

/// Kind 0 meets the triangle, 1 has it behind, 2 ends where it begins.
template <class T>
void wrong_way(Trials<T>& trials, double kind, Random& random) {
  const Triangle<double> triangle = plain_triangle(random);
  Ray<T> ray = meeting<T>(triangle, random);
  if (kind == 1) ray.direction = -ray.direction;
  trials.add(ray, rounded<T>(triangle), kind == 2 ? T(0) : std::numeric_limits<T>::infinity());
}

}  // namespace

std::vector<Case> end_cases() {
  const std::string_view ours = "this study";
  return {
      with_each({"E3",
                 "origin on the surface",
                 ours,
                 Expectation::decided,
                 "distance above or below it, in ulps of 1",
                 {256, 64, 16, 4, 1, 0}},
                [](auto& trials, double ulps, Random& random) { on_surface(trials, ulps, random); }),
      with_each({"E6",
                 "ray that ends where it hits",
                 ours,
                 Expectation::decided,
                 "distance between end and hit, in ulps of t",
                 {1024, 64, 8, 2, 1, 0}},
                [](auto& trials, double ulps, Random& random) { end_at_hit(trials, ulps, random); }),
      with_each({"E7",
                 "triangle before, behind and beyond the ray",
                 ours,
                 Expectation::decided,
                 "kind: 0 before, t_max infinite; 1 behind; 2 t_max = t_min = 0",
                 {0, 1, 2}},
                [](auto& trials, double kind, Random& random) { wrong_way(trials, kind, random); }),
  };
}

}  // namespace raysweep
