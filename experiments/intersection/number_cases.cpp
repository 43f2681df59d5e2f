#include "experiments/intersection/draw.h"
#include "experiments/intersection/families.h"

namespace raysweep {

namespace {

/// `v` with its axes renamed: x, y, z become x + shift, …
template <class T>
Vec3<T> shifted(const Vec3<T>& v, size_t shift) {
  return shift == 0 ? v : shift == 1 ? Vec3<T>(v.z, v.x, v.y) : Vec3<T>(v.y, v.z, v.x);
}

/// Along an axis; the sign of the direction's zeros is that of each bit of `signs`.
template <class T>
void signed_zeros(Trials<T>& trials, double signs, Random& random) {
  const auto zero = [&](int bit) { return (static_cast<int>(signs) >> bit & 1) != 0 ? T(-0.0) : T(0.0); };
  const size_t shift = random.index(3);
  const T z = random.index(2) == 0 ? T(1) : T(2.1);
  const Triangle<T> flat{{-1, -1, z}, {1, -1, z}, {-1, 1, z}};
  const auto coordinate = [&] { return static_cast<T>(2.4 * uniform(random) - 1.2); };
  const T x = coordinate();
  const Vec3<T> origin(x, coordinate(), 0), direction(zero(0), zero(1), 1);
  trials.add({shifted(origin, shift), shifted(direction, shift)},
             {shifted(flat.a, shift), shifted(flat.b, shift), shifted(flat.c, shift)});
}

/// A component that is almost, but not, 0.
template <class T>
void tiny_component(Trials<T>& trials, double size, Random& random) {
  const Triangle<double> triangle = plain_triangle(random);
  const size_t shift = random.index(3);
  const double x = random.sign() * size, y = random.index(2) == 0 ? uniform(random) : random.sign() * size;
  const Vec3<T> direction = shifted(Vec3<T>(Vec3d(x, y, random.sign())), shift);
  const Vec3d target = point_about(triangle, random);
  trials.add({Vec3<T>(target) - direction * T(2), direction}, rounded<T>(triangle));
}

/// Of the 15 numbers of a ray and a triangle that meet, one is NaN or infinite.
template <class T>
void not_finite(Trials<T>& trials, double place, Random& random) {
  const Triangle<double> triangle = plain_triangle(random);
  const Vec3d target = triangle.a * 0.4 + triangle.b * 0.3 + triangle.c * 0.3;
  const Ray<T> ray =
      aimed(Vec3<T>(target + view_of(normal_of(triangle), 0.2, random) * 4.0), Vec3<T>(target));
  const Triangle<T> t = rounded<T>(triangle);
  Vec3<T> vectors[] = {ray.origin, ray.direction, t.a, t.b, t.c};
  const T infinity = std::numeric_limits<T>::infinity(), nan = std::numeric_limits<T>::quiet_NaN();
  const T values[] = {nan, infinity, -infinity};
  const auto index = static_cast<size_t>(place);
  Vec3<T>& v = vectors[index / 3];
  (index % 3 == 0 ? v.x : index % 3 == 1 ? v.y : v.z) = values[random.index(3)];
  trials.add({vectors[0], vectors[1]}, {vectors[2], vectors[3], vectors[4]});
}

}  // namespace

std::vector<Case> number_cases() {
  return {
      with_each({"N2",
                 "axis-parallel ray with zeros of either sign",
                 "octants by d < 0",
                 Expectation::decided,
                 "bits: which of two zeros are negative",
                 {0, 1, 2, 3}},
                [](auto& trials, double signs, Random& random) { signed_zeros(trials, signs, random); }),
      with_each({"N4",
                 "ray that is almost axis-parallel",
                 "nanort issue 30",
                 Expectation::decided,
                 "the direction's small components",
                 {1e-4, 1e-8, 1e-17, 1e-30, 1e-40}},
                [](auto& trials, double size, Random& random) { tiny_component(trials, size, random); }),
      with_each({"N6",
                 "a number that is NaN or infinite",
                 "this study",
                 Expectation::must_miss,
                 "which: 0 to 2 origin, to 5 direction, to 14 corners",
                 {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14}},
                [](auto& trials, double place, Random& random) { not_finite(trials, place, random); }),
  };
}

}  // namespace raysweep
