#include "tracer/scene/rock.h"

#include <gtest/gtest.h>

#include <random>

#include "tracer/scene/solid.h"

namespace raysweep {
namespace {

Vec3d any_point(std::mt19937& random) {
  std::uniform_real_distribution<double> uniform(-50, 50);
  const double x = uniform(random), y = uniform(random), z = uniform(random);
  return {x, y, z};
}

TEST(gradient_noise, is_0_on_its_lattice_and_fills_its_range_elsewhere) {
  std::mt19937 random(1);
  double lowest = 0, highest = 0, sum = 0;
  constexpr int count = 20000;
  for (int i = 0; i < count; ++i) {
    const Vec3d p = any_point(random);
    EXPECT_EQ(gradient_noise({std::floor(p.x), std::floor(p.y), std::floor(p.z)}, 7), 0);
    const double value = gradient_noise(p, 7);
    lowest = std::min(lowest, value);
    highest = std::max(highest, value);
    sum += value;
  }
  EXPECT_GT(lowest, -1.1);
  EXPECT_LT(lowest, -0.6);
  EXPECT_LT(highest, 1.1);
  EXPECT_GT(highest, 0.6);
  EXPECT_NEAR(sum / count, 0, 0.01);
}

TEST(gradient_noise, is_smooth_across_the_faces_of_its_lattice) {
  std::mt19937 random(2);
  constexpr double step = 1e-4;
  for (int i = 0; i < 2000; ++i) {
    Vec3d p = any_point(random);
    p.x = std::floor(p.x);
    const double before = gradient_noise(p - Vec3d(step, 0, 0), 3), at = gradient_noise(p, 3),
                 after = gradient_noise(p + Vec3d(step, 0, 0), 3);
    EXPECT_NEAR(after - at, at - before, 1e-6) << "first derivative: differences of second order";
  }
}

TEST(gradient_noise, is_another_for_another_seed) {
  EXPECT_NE(gradient_noise({0.3, 0.4, 0.5}, 1), gradient_noise({0.3, 0.4, 0.5}, 2));
}

TEST(rock, without_octaves_is_the_stretched_sphere) {
  const Mesh mesh = make_rock(
      {.frequency = 6, .octaves = 0, .lumps = 1, .height = 1, .roughness = 1, .stretch = {2, 3, 4}});
  for (const Vec3f& v : mesh.vertices) EXPECT_NEAR(length(Vec3d(v.x / 2, v.y / 3, v.z / 4)), 1, 1e-6);
}

TEST(rock, octaves_add_up_and_shrink_by_the_roughness) {
  Rock rock{.frequency = 20, .octaves = 1, .lumps = 2, .height = 0.2, .roughness = 0.25, .seed = 9};
  const Mesh coarse = make_rock(rock);
  rock.octaves = 2;
  const Mesh fine = make_rock(rock);
  float largest = 0;
  for (size_t i = 0; i < coarse.vertices.size(); ++i)
    largest = std::max(largest, length(fine.vertices[i] - coarse.vertices[i]));
  EXPECT_LT(largest, 1.1 * 0.2 * 0.25);
  EXPECT_GT(largest, 0.5 * 0.2 * 0.25);
}

TEST(rock, closes_whatever_the_seed) {
  for (uint32_t seed = 0; seed < 5; ++seed) {
    const Mesh mesh =
        make_rock({.frequency = 15, .octaves = 4, .lumps = 2, .height = 0.3, .roughness = 0.4, .seed = seed});
    EXPECT_TRUE(is_closed(mesh));
    EXPECT_GT(signed_volume(mesh), 0);
  }
}

}  // namespace
}  // namespace raysweep
