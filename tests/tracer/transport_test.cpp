// Light is neither made nor lost on its way, and what paths leave out stays within what is said.
#include <gtest/gtest.h>

#include <random>

#include "tests/tracer/variants.h"
#include "tracer/scene/scenes.h"
#include "tracer/scene/shapes.h"

namespace raysweep {
namespace {

/// Spheres and boxes of random materials whose coefficients sum to `sum`, under white light from everywhere.
Scene furnace(uint64_t seed, double sum) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> uniform(0, 1);
  Scene scene;
  scene.background = {1, 1, 1};
  for (int i = 0; i < 8; ++i) {
    const double a = uniform(random), b = uniform(random), c = uniform(random);
    const double scale = sum / (a + b + c);
    Material m{.k_ambient = a * scale, .k_diffuse = 0, .k_specular = 0};
    m.k_reflect = b * scale;
    m.k_refract = i % 3 == 0 ? 0 : c * scale;
    if (m.k_refract == 0) m.k_ambient += c * scale;
    m.ior = 1 + uniform(random);
    m.fresnel = i % 2 == 0;
    m.priority = i % 4;
    scene.materials.push_back(m);
    const Vec3d at(2 * uniform(random) - 1, 2 * uniform(random) - 1, 2 * uniform(random) - 1);
    const double size = 0.2 + 0.6 * uniform(random);
    const auto material = static_cast<uint32_t>(i);
    if (i % 2 == 0) scene.spheres.push_back({at, size, material});
    Mesh mesh;
    append_box(mesh, at - Vec3d(size, size, size), at + Vec3d(size, 0.5 * size, size));
    mesh.material = material;
    if (i % 2 == 1) scene.meshes.push_back(mesh);
  }
  scene.camera = {.position = {0.3, 0.5, 4}, .target = {0, 0, 0}, .half_angle = 0.35};
  return scene;
}

RenderSettings small(int side, int depth) {
  RenderSettings s;
  s.width = s.height = side;
  s.depth = depth;
  return s;
}

TEST(energy, in_a_white_furnace_coefficients_that_sum_to_1_are_invisible) {
  for (uint64_t seed = 1; seed <= 3; ++seed) {
    RenderSettings s = small(20, 200);
    s.branches = 1 << 12;
    RenderCounts counts;
    const Film film = picture_of(furnace(seed, 1), s, &counts);
    const auto bound = static_cast<float>(counts.left_out.bound);
    for (const Vec3f& p : film.pixels()) {
      ASSERT_LE(p.x, 1 + 1e-4f) << seed;
      ASSERT_GE(p.x, 1 - 1e-4f - bound) << seed << ": what is missing is at most what was left out";
    }
    EXPECT_GT(counts.rays.refracted, 1000u);
    EXPECT_LT(bound, 0.1);
  }
}

TEST(energy, coefficients_that_sum_to_1_or_less_never_brighten) {
  for (uint64_t seed = 1; seed <= 20; ++seed) {
    for (const double sum : {1.0, 0.9, 0.3}) {
      for (const int depth : {1, 2, 5, 12}) {
        const Film film = picture_of(furnace(seed, sum), small(16, depth));
        for (const Vec3f& p : film.pixels()) ASSERT_LE(p.x, 1 + 1e-5f);
      }
    }
  }
}

class EveryScene : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(transport, EveryScene, testing::ValuesIn(scene_names()), [](const auto& info) {
  std::string name = info.param;
  std::ranges::replace(name, '-', '_');
  return name;
});

TEST_P(EveryScene, a_tolerance_is_kept_in_every_pixel_and_saves_rays) {
  const Scene scene = load_scene(GetParam(), 2);
  RenderSettings s = small(48, 9);
  RenderCounts whole_counts;
  const Film whole = picture_of(scene, s, &whole_counts);
  EXPECT_EQ(whole_counts.left_out.by_tolerance, 0u);
  EXPECT_EQ(whole_counts.left_out.bound, 0);
  for (const double tolerance : {1e-4, 1e-2, 0.2}) {
    s.pixel_tolerance = tolerance;
    RenderCounts counts;
    const Film film = picture_of(scene, s, &counts);
    EXPECT_LE(counts.left_out.bound, tolerance);
    EXPECT_LE(counts.rays.total(), whole_counts.rays.total());
    for (size_t i = 0; i < film.pixels().size(); ++i)
      ASSERT_LE(max_abs(film.pixels()[i] - whole.pixels()[i]), tolerance + 1e-6);
  }
}

TEST_P(EveryScene, no_pixel_is_ever_anything_but_finite_and_no_path_loses_its_medium) {
  const Scene scene = load_scene(GetParam(), 3);
  for (RenderSettings s : all_variants()) {
    if (s.accel == "none" || (s.core == "m11" && s.precision == "double")) continue;  // same hits
    s.width = 40;
    s.height = 30;
    for (const int depth : {1, 8}) {
      s.depth = depth;
      RenderCounts counts;
      const Film film = picture_of(scene, s, &counts);
      for (const Vec3f& p : film.pixels()) {
        ASSERT_TRUE(all_finite(p));
        ASSERT_GE(std::min({p.x, p.y, p.z}), 0);
      }
      EXPECT_EQ(counts.left_out.lost_media, 0u);
    }
  }
}

TEST_P(EveryScene, depth_1024_ends_and_says_what_it_left_out) {
  const Scene scene = load_scene(GetParam(), 1);
  RenderSettings s = small(12, 1024);
  s.branches = 300;
  RenderCounts counts;
  (void)picture_of(scene, s, &counts);
  const uint64_t samples = 144;
  EXPECT_EQ(counts.rays.primary, samples);
  if (has_transparency(scene)) {
    EXPECT_LE(counts.rays.total() - counts.rays.shadow, samples * 300);
  }
  EXPECT_EQ(counts.left_out.by_branches > 0, counts.left_out.bound > 0);
}

TEST(transport, a_tolerance_is_kept_whatever_the_materials) {
  std::mt19937_64 random(8);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (uint64_t seed = 1; seed <= 40; ++seed) {
    Scene scene = furnace(seed, 1);
    for (Material& m : scene.materials) {
      m.k_ambient = std::pow(10, 6 * uniform(random) - 4);  // dim and glaring side by side
      const double passed = m.k_reflect + m.k_refract;
      m.k_reflect /= passed;
      m.k_refract /= passed;
    }
    RenderSettings s = small(6, 12);
    s.precision = "double";
    s.branches = 1 << 14;
    const Film whole = picture_of(scene, s);
    for (const double tolerance : {1e-4, 1.0}) {
      s.pixel_tolerance = tolerance;
      RenderCounts counts;
      const Film film = picture_of(scene, s, &counts);
      EXPECT_LE(counts.left_out.bound, tolerance);
      for (size_t i = 0; i < film.pixels().size(); ++i) {
        const float value = max_abs(whole.pixels()[i]);  // whose last digits the film does not hold
        ASSERT_LE(max_abs(film.pixels()[i] - whole.pixels()[i]),
                  tolerance + 1e-6 * static_cast<double>(value));
      }
    }
  }
}

TEST(transport, materials_that_make_light_are_refused) {
  for (const auto& spoil : std::vector<void (*)(Material&)>{
           [](Material& m) { m.k_reflect = 0.6, m.k_refract = 0.5; }, [](Material& m) { m.k_reflect = 1.01; },
           [](Material& m) {
             m.filter = {1, 1.1, 1};
           },
           [](Material& m) { m.k_diffuse = -1; }, [](Material& m) { m.ior = 0; },
           [](Material& m) { m.ambient.x = std::nan(""); }}) {
    Scene scene = furnace(1, 1);
    spoil(scene.materials[0]);
    EXPECT_THROW((void)make_renderer(scene, small(4, 2)), std::invalid_argument);
  }
}

TEST(transport, a_sample_that_may_trace_one_ray_traces_one_and_says_what_is_missing) {
  const Scene scene = furnace(3, 1);
  RenderSettings s = small(16, 10);
  s.branches = 1;
  RenderCounts counts;
  const Film film = picture_of(scene, s, &counts);
  EXPECT_EQ(counts.rays.reflected + counts.rays.refracted, 0u);
  EXPECT_GT(counts.left_out.by_branches, 0u);
  for (const Vec3f& p : film.pixels()) EXPECT_GE(p.x + static_cast<float>(counts.left_out.bound), 1 - 1e-5f);
}

TEST(transport, what_the_depth_limit_cuts_off_is_counted) {
  RenderSettings s = small(16, 1);
  RenderCounts counts;
  (void)picture_of(furnace(3, 1), s, &counts);
  EXPECT_GT(counts.left_out.by_depth, 0u);
  EXPECT_EQ(counts.left_out.bound, 0) << "by definition the depth limit takes nothing away";
}

}  // namespace
}  // namespace raysweep
