// Pictures whose colours are known from formulas, on every core, precision and method.
#include <gtest/gtest.h>

#include <map>
#include <set>

#include "tests/tracer/variants.h"
#include "tracer/scene/scenes.h"

namespace raysweep {
namespace {

/// The only pixel: what the camera's axis sees.
Vec3f central_colour(const Scene& scene, const RenderSettings& settings, RayCounts* rays = nullptr) {
  RenderCounts counts;
  const Film film = picture_of(scene, settings, &counts);
  if (rays) *rays = counts.rays;
  return film.at(0, 0);
}

Scene lit_sphere() {
  Scene scene;
  scene.materials = {{.ambient = {1, 0.5, 0.25},
                      .diffuse = {0.5, 1, 0.5},
                      .specular = {0, 0, 1},
                      .k_ambient = 0.1,
                      .k_diffuse = 0.6,
                      .k_specular = 0.3,
                      .exponent = 10}};
  scene.spheres = {{{0, 0, 0}, 1, 0}};
  scene.camera = {.position = {0, 0, 5}, .target = {0, 0, 0}, .half_angle = 0.1};
  scene.lights = {{{0, 0, 9}, {1, 1, 1}}};
  scene.background = {0.3, 0.2, 0.1};
  return scene;
}

TEST(shading, a_sphere_lit_from_the_eye_shows_all_three_terms) {
  for (const RenderSettings& s : all_variants()) {
    const Vec3f c = central_colour(lit_sphere(), s);
    EXPECT_NEAR(c.x, 0.1 * 1 + 0.6 * 0.5, 1e-5);
    EXPECT_NEAR(c.y, 0.1 * 0.5 + 0.6 * 1, 1e-5);
    EXPECT_NEAR(c.z, 0.1 * 0.25 + 0.6 * 0.5 + 0.3, 1e-5);
  }
}

TEST(shading, a_slanted_light_follows_lambert_and_phong) {
  Scene scene = lit_sphere();
  scene.lights = {
      {{3, 0, 5},
       {1, 1, 1}}};  // 3 beside, 4 above the point (0, 0, 1): cosine 0.8 to the normal and to the mirror
  for (const RenderSettings& s : all_variants()) {
    const Vec3f c = central_colour(scene, s);
    EXPECT_NEAR(c.x, 0.1 + 0.6 * 0.5 * 0.8, 1e-5);
    EXPECT_NEAR(c.z, 0.1 * 0.25 + 0.6 * 0.5 * 0.8 + 0.3 * std::pow(0.8, 10), 1e-5);
  }
}

TEST(shading, a_miss_is_background) {
  Scene scene = lit_sphere();
  scene.spheres[0].centre = {5, 0, 0};
  for (const RenderSettings& s : all_variants()) EXPECT_EQ(central_colour(scene, s), Vec3f(0.3f, 0.2f, 0.1f));
}

TEST(shading, a_shadowed_point_keeps_its_ambient_term) {
  Scene scene = lit_sphere();
  scene.lights = {{{8, 0, 9}, {1, 1, 1}}};
  scene.spheres.push_back({{4, 0, 5}, 0.5, 0});  // halfway to the light, out of the eye's way
  for (const RenderSettings& s : all_variants()) {
    const Vec3f c = central_colour(scene, s);
    EXPECT_NEAR(c.x, 0.1, 1e-6);
    EXPECT_NEAR(c.y, 0.05, 1e-6);
  }
}

TEST(shading, an_occluder_behind_the_light_casts_no_shadow) {
  Scene scene = lit_sphere();
  const Vec3f lit = central_colour(scene, all_variants().front());
  scene.spheres.push_back({{0, 0, 12}, 1, 0});
  for (const RenderSettings& s : all_variants()) EXPECT_NEAR(central_colour(scene, s).x, lit.x, 1e-6);
}

TEST(shading, a_light_behind_the_surface_costs_no_shadow_ray) {
  Scene scene = lit_sphere();
  scene.lights = {{{0, 0, -9}, {1, 1, 1}}, {{0, 0, 9}, {1, 1, 1}}};
  for (const RenderSettings& s : all_variants()) {
    RayCounts rays;
    (void)central_colour(scene, s, &rays);
    EXPECT_EQ(rays, (RayCounts{1, 1, 0, 0}));
  }
}

/// Two facing mirrors with ambient 1: what comes back after d hits is the sum of d powers of k_reflect.
Scene mirrors(double k_reflect) {
  Scene scene;
  scene.materials = {{.k_ambient = 1, .k_diffuse = 0, .k_specular = 0, .k_reflect = k_reflect}};
  scene.planes = {{{0, 0, 1}, 1, 0}, {{0, 0, -1}, 1, 0}};  // z = −1 and z = 1
  scene.camera = {.position = {0, 0, 0}, .target = {0, 0, -1}, .half_angle = 0.1};
  return scene;
}

TEST(shading, depth_d_sums_d_reflections) {
  for (RenderSettings s : all_variants()) {
    for (const int depth : {1, 2, 3, 1024}) {
      s.depth = depth;
      RayCounts rays;
      const Vec3f c = central_colour(mirrors(0.5), s, &rays);
      EXPECT_NEAR(c.x, 2 * (1 - std::pow(0.5, depth)), 1e-5);
      EXPECT_EQ(rays.reflected, static_cast<uint64_t>(depth - 1));
      EXPECT_NEAR(central_colour(mirrors(1), s).x, depth, 1e-3 * depth);
    }
  }
}

TEST(shading, no_reflection_without_a_mirror) {
  RenderSettings s = all_variants().front();
  s.depth = 9;
  RayCounts rays;
  (void)central_colour(mirrors(0), s, &rays);
  EXPECT_EQ(rays.reflected, 0u);
}

TEST(render, every_variant_gives_one_picture_whatever_the_hierarchy_and_core) {
  std::map<std::string, std::set<std::string>> hashes;
  for (RenderSettings s : all_variants()) {
    s.width = 24;
    s.height = 18;
    s.subpixels = 3;
    for (const int leaf : {1, 4, 100000}) {
      s.leaf = leaf;
      Film film(s.width, s.height);
      make_renderer(load_scene("chair-ball", 2), s)->render({0, 0, s.width, s.height}, film);
      hashes[s.precision + s.method].insert(film.hash());
      for (const Vec3f& p : film.pixels()) ASSERT_TRUE(all_finite(p));
    }
  }
  for (const auto& [variant, pictures] : hashes) EXPECT_EQ(pictures.size(), 1u) << variant;
  EXPECT_EQ(hashes.size(), precisions().size() * methods().size());
}

TEST(render, a_picture_in_tiles_is_the_picture_in_one) {
  RenderSettings s;
  s.width = 50;
  s.height = 37;
  const auto renderer = make_renderer(load_scene("studio", 1), s);
  Film whole(50, 37), tiled(50, 37);
  const RenderCounts rays = renderer->render({0, 0, 50, 37}, whole);
  RenderCounts sum;
  for (int y = 0; y < 37; y += 8) {
    for (int x = 0; x < 50; x += 8)
      sum += renderer->render({x, y, std::min(8, 50 - x), std::min(8, 37 - y)}, tiled);
  }
  EXPECT_EQ(whole.hash(), tiled.hash());
  EXPECT_EQ(rays, sum);
}

TEST(render, unknown_names_are_refused) {
  for (std::string RenderSettings::*name :
       {&RenderSettings::core, &RenderSettings::precision, &RenderSettings::method, &RenderSettings::accel,
        &RenderSettings::pattern}) {
    RenderSettings s;
    s.*name = "nonsense";
    EXPECT_THROW((void)make_renderer(lit_sphere(), s), std::invalid_argument);
  }
}

}  // namespace
}  // namespace raysweep
