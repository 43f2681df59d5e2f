// Directions and shares obey the laws of optics, for a million random inputs each.
#include <gtest/gtest.h>

#include <random>

#include "tracer/shade/phong.h"
#include "tracer/shade/refraction.h"

namespace raysweep {
namespace {

constexpr int trials = 1'000'000;

template <class T>
class Optics : public testing::Test {
 protected:
  static constexpr T epsilon = std::numeric_limits<T>::epsilon();

  T uniform(double low, double high) {
    return static_cast<T>(std::uniform_real_distribution<double>(low, high)(random_));
  }
  Vec3<T> unit_vector() {
    for (;;) {
      const Vec3<T> v(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1));
      if (length(v) > T(0.01) && length(v) < 1) return normalize(v);
    }
  }
  /// A unit vector against `normal`; every tenth grazes it.
  Vec3<T> incident_on(const Vec3<T>& normal) {
    for (;;) {
      Vec3<T> v = unit_vector();
      if (dot(v, normal) > 0) v = -v;
      if (random_() % 10 == 0) v = normalize(v - normal * (dot(v, normal) * uniform(0.9, 1)));
      if (dot(v, normal) < -10 * epsilon) return v;
    }
  }
  static T sine(const Vec3<T>& direction, const Vec3<T>& normal) { return length(cross(direction, normal)); }

  std::mt19937_64 random_{7};
};
using Reals = testing::Types<float, double>;
TYPED_TEST_SUITE(Optics, Reals);

TYPED_TEST(Optics, a_mirror_turns_the_normal_component_and_keeps_the_rest) {
  using T = TypeParam;
  for (int i = 0; i < trials; ++i) {
    const Vec3<T> n = this->unit_vector(), in = this->incident_on(n), out = reflect(in, n);
    ASSERT_NEAR(dot(out, n), -dot(in, n), 8 * this->epsilon);
    ASSERT_NEAR(length(out), 1, 16 * this->epsilon);
    ASSERT_NEAR(dot(cross(in, n), out), 0, 8 * this->epsilon) << "coplanar";
    ASSERT_LE(length(cross(in, n) - cross(out, n)), 16 * this->epsilon) << "equal angles, same side";
  }
}

TYPED_TEST(Optics, refraction_obeys_snells_law_in_the_plane_of_incidence) {
  using T = TypeParam;
  int refracted = 0, reflected = 0;
  for (int i = 0; i < trials; ++i) {
    const Vec3<T> n = this->unit_vector(), in = this->incident_on(n);
    const T eta = this->uniform(0.3, 3);
    const T sine = eta * this->sine(in, n);
    const auto out = refract(in, n, eta);
    if (!out) {
      reflected++;
      ASSERT_GE(sine, 1 - 8 * this->epsilon) << "total reflection below the critical angle";
      continue;
    }
    refracted++;
    ASSERT_LE(sine, 1 + 8 * this->epsilon) << "refraction beyond the critical angle";
    ASSERT_NEAR(this->sine(out->direction, n), sine, 8 * this->epsilon * (1 + eta));
    ASSERT_NEAR(length(out->direction), 1, 8 * this->epsilon);
    ASSERT_LE(dot(out->direction, n), 4 * this->epsilon) << "on the other side";
    ASSERT_NEAR(dot(cross(in, n), out->direction), 0, 8 * this->epsilon * (1 + eta)) << "coplanar";
    // Tangents have one direction: bent towards or away from the normal, not across it.
    ASSERT_LE(length(cross(in, n) * eta - cross(out->direction, n)), 16 * this->epsilon * (1 + eta));
  }
  EXPECT_GT(refracted, trials / 4);
  EXPECT_GT(reflected, trials / 20);
}

TYPED_TEST(Optics, light_that_comes_back_goes_the_same_way_and_shares_alike) {
  using T = TypeParam;
  for (int i = 0; i < trials; ++i) {
    const Vec3<T> n = this->unit_vector(), in = this->incident_on(n);
    const T n1 = this->uniform(1, 2.5), n2 = this->uniform(1, 2.5);
    const auto out = refract(in, n, n1 / n2);
    if (!out || std::min(out->cos_incident, out->cos_transmitted) < T(0.01)) continue;
    // Cosines are as uncertain as sines over the cosine; shares as cosines are.
    const T cosine = std::min(out->cos_incident, out->cos_transmitted);
    const auto back = refract(-out->direction, -n, n2 / n1);
    ASSERT_TRUE(back);
    ASSERT_LE(length(back->direction + in), 16 * this->epsilon / cosine);
    const T there = fresnel(n1, n2, out->cos_incident, out->cos_transmitted);
    const T back_again = fresnel(n2, n1, back->cos_incident, back->cos_transmitted);
    ASSERT_GE(there, 0);
    ASSERT_LE(there, 1 + 4 * this->epsilon);
    ASSERT_NEAR(there, back_again, 32 * this->epsilon / (cosine * cosine));
  }
}

TYPED_TEST(Optics, fresnel_is_known_at_right_angles_at_brewsters_angle_and_at_the_critical_one) {
  using T = TypeParam;
  EXPECT_NEAR(fresnel<T>(1, T(1.5), 1, 1), T(0.04), 4 * this->epsilon);
  // At tan i = n2/n1 all reflected light is polarised: half of s² is left.
  const T n2 = T(1.5), tangent = n2, cos_i = 1 / std::sqrt(1 + tangent * tangent), cos_t = tangent * cos_i;
  const T s = (cos_i - n2 * cos_t) / (cos_i + n2 * cos_t);
  EXPECT_NEAR(fresnel<T>(1, n2, cos_i, cos_t), s * s / 2, 4 * this->epsilon);
  EXPECT_NEAR(fresnel<T>(n2, 1, std::sqrt(1 - 1 / (n2 * n2)), 0), 1, 4 * this->epsilon);
}

TYPED_TEST(Optics, equal_media_bend_nothing) {
  using T = TypeParam;
  for (int i = 0; i < 1000; ++i) {
    const Vec3<T> n = this->unit_vector(), in = this->incident_on(n);
    if (dot(in, n) > T(-0.01)) continue;
    const auto out = refract(in, n, T(1));
    ASSERT_TRUE(out);
    ASSERT_LE(length(out->direction - in), 1000 * this->epsilon);
    EXPECT_NEAR(fresnel<T>(1, 1, out->cos_incident, out->cos_incident), 0, this->epsilon);
  }
}

}  // namespace
}  // namespace raysweep
