// Pictures that a formula gives, pixel by pixel, in every core, precision, method and hierarchy.
#include <gtest/gtest.h>

#include <numbers>

#include "tests/tracer/variants.h"
#include "tracer/scene/shapes.h"

namespace raysweep {
namespace {

const Material white{.k_ambient = 0, .k_diffuse = 1, .k_specular = 0};
const Material red_glow{.ambient = {1, 0, 0}, .k_ambient = 1, .k_diffuse = 0, .k_specular = 0};

Mesh box(const Vec3d& lower, const Vec3d& upper, uint32_t material) {
  Mesh mesh;
  append_box(mesh, lower, upper);
  mesh.material = material;
  return mesh;
}

/// The direction through the centre of pixel (x, y) of a camera that looks along −z with y up.
Vec3d through(const RenderSettings& s, double half_angle, double x, double y) {
  const double t = std::tan(half_angle);
  return normalize(
      Vec3d((2 * (x + 0.5) / s.width - 1) * t * s.width / s.height, (1 - 2 * (y + 0.5) / s.height) * t, -1));
}

double tolerance(const RenderSettings& s) {
  return s.precision == "float" ? 2e-5 : 1e-7;
}  // films hold floats

TEST(closed_form, a_lit_plane_is_lamberts_cosine_in_every_pixel) {
  const Vec3d light(1, 4, -3);
  Scene plane;
  plane.materials = {white};
  plane.planes = {{{0, 1, 0}, 1, 0}};  // y = −1
  plane.camera = {.position = {0, 0, 0}, .target = {0, 0, -1}, .half_angle = 0.5};
  plane.lights = {{light, {0.8, 0.8, 0.8}}};
  Scene slab = plane;
  slab.planes.clear();
  slab.meshes = {box({-99, -2, -99}, {99, -1, 99}, 0)};
  for (RenderSettings s : all_variants()) {
    s.width = 40;
    s.height = 30;
    const Film of_plane = picture_of(plane, s), of_slab = picture_of(slab, s);
    int lit = 0;
    for (int y = 0; y < s.height; ++y) {
      for (int x = 0; x < s.width; ++x) {
        const Vec3d d = through(s, 0.5, x, y);
        if (d.y > -0.02) continue;  // the horizon, beyond the slab
        const Vec3d point = d * (-1 / d.y);
        const double expected = 0.8 * normalize(light - point).y;
        ASSERT_NEAR(of_plane.at(x, y).x, expected, tolerance(s)) << x << ' ' << y;
        ASSERT_NEAR(of_slab.at(x, y).x, expected, 5 * tolerance(s)) << x << ' ' << y;
        lit++;
      }
    }
    EXPECT_GT(lit, 500);
  }
}

TEST(closed_form, a_sphere_covers_the_area_of_its_silhouette_and_is_shaded_by_its_normal) {
  const double distance = 5, radius = 1, half_angle = 0.3;
  const Vec3d light(3, 2, 6);
  Scene scene;
  scene.materials = {white};
  scene.spheres = {{{0, 0, 0}, radius, 0}};
  scene.camera = {.position = {0, 0, distance}, .target = {0, 0, 0}, .half_angle = half_angle};
  scene.lights = {{light, {1, 1, 1}}};
  scene.background = {2, 2, 2};
  // The cone around the sphere meets the picture's plane in a circle of this radius, in half picture heights.
  const double silhouette = std::tan(std::asin(radius / distance)) / std::tan(half_angle);
  for (RenderSettings s : all_variants()) {
    s.width = s.height = s.accel == "sah" ? 400 : 60;
    const Film film = picture_of(scene, s);
    double covered = 0;
    for (int y = 0; y < s.height; ++y) {
      for (int x = 0; x < s.width; ++x) {
        const float c = film.at(x, y).x;
        covered += c != 2 ? 1 : 0;
        if (c == 2) continue;
        const Vec3d d = through(s, half_angle, x, y);
        const double b = -distance * d.z, under = b * b - (distance * distance - radius * radius);
        if (under < 1e-3) continue;  // at the rim rounding decides
        const Vec3d n = Vec3d(0, 0, distance) + d * (b - std::sqrt(under));
        const double cosine = dot(n, normalize(light - n));
        ASSERT_NEAR(c, std::max(0.0, cosine), 10 * tolerance(s)) << x << ' ' << y;
      }
    }
    const double expected = std::numbers::pi * silhouette * silhouette / 4;
    // Counting centres in a circle of r pixels errs by about √r; here far less than the bound.
    const double pixels = silhouette * s.width / 2;
    EXPECT_NEAR(covered / (s.width * s.height), expected, 4 * std::sqrt(pixels) / (s.width * s.height));
  }
}

TEST(closed_form, between_parallel_mirrors_depth_d_shows_d_minus_1_images_where_unfolding_puts_them) {
  const double aside = 1, radius = 0.04, half_angle = 0.5;
  Scene scene;
  scene.materials = {{.k_ambient = 0, .k_diffuse = 0, .k_specular = 0, .k_reflect = 1}, red_glow};
  scene.planes = {{{0, 0, 1}, 1, 0}, {{0, 0, -1}, 1, 0}};  // z = −1 and z = 1
  scene.spheres = {{{aside, 0, 0}, radius, 1}};
  scene.camera = {.position = {0, 0, 0}, .target = {0, 0, -1}, .half_angle = half_angle};
  for (RenderSettings s : all_variants()) {
    s.width = 2001;
    s.height = 2001;  // a square picture, of which one row is rendered
    for (const int depth : {1, 2, 3, 6}) {
      s.depth = depth;
      Film film(s.width, s.height);
      (void)make_renderer(scene, s)->render({0, 1000, 2001, 1}, film);
      for (int k = 1; k <= 7; ++k) {
        // The k-th image lies 2k behind: it spans these angles.
        const double middle = std::atan2(aside, 2.0 * k),
                     half = std::asin(radius / std::hypot(aside, 2.0 * k));
        for (const double at : {-1.1, -0.9, 0.0, 0.9, 1.1}) {
          const double column = (std::tan(middle + at * half) / std::tan(half_angle) + 1) * s.width / 2;
          if (column > s.width - 1) continue;
          const bool seen = film.at(static_cast<int>(column), 1000).x > 0.5f;
          EXPECT_EQ(seen, k < depth && std::abs(at) < 1)
              << "image " << k << " at depth " << depth << ' ' << at;
        }
      }
    }
  }
}

TEST(closed_form, a_glass_slab_shifts_what_is_behind_it) {
  const double n = 1.5, thickness = 0.7, gap = 1, behind = 1.3, half_angle = 0.6;
  Scene scene;
  scene.materials = {{.k_ambient = 0, .k_diffuse = 0, .k_specular = 0, .k_refract = 1, .ior = n}, red_glow};
  // A slab from z = −gap on; a red wall behind it that covers x < 0.3.
  const double wall = -(gap + thickness + behind), edge = 0.3;
  scene.meshes = {box({-50, -50, -gap - thickness}, {50, 50, -gap}, 0),
                  box({-50, -50, wall - 1}, {edge, 50, wall}, 1)};
  scene.camera = {.position = {0, 0, 0}, .target = {0, 0, -1}, .half_angle = half_angle};
  scene.background = {0, 1, 0};
  for (RenderSettings s : all_variants()) {
    s.width = s.height = 1501;
    Film film(s.width, s.height);
    (void)make_renderer(scene, s)->render({0, 750, 1501, 1}, film);
    int checked = 0, shifted = 0;
    for (int x = 0; x < s.width; ++x) {
      const Vec3d d = through(s, half_angle, x, 750);
      const double tangent = d.x / -d.z, sine = d.x / n, inside = sine / std::sqrt(1 - sine * sine);
      const double at_wall = tangent * (gap + behind) + inside * thickness;
      const double unshifted = tangent * (gap + behind + thickness);
      if (std::abs(at_wall - edge) < 1e-4) continue;
      ASSERT_NEAR(film.at(x, 750).x, at_wall < edge ? 1 : 0, 1e-6) << x;
      checked++;
      shifted += (at_wall < edge) != (unshifted < edge);
    }
    EXPECT_GT(checked, 1490);
    EXPECT_GT(shifted, 3) << "the shift is wide enough to be seen";
  }
}

TEST(closed_form, from_under_water_the_sky_is_a_window_of_the_critical_angle) {
  const double n = 1.333;
  Scene scene;
  scene.materials = {{.k_ambient = 0, .k_diffuse = 0, .k_specular = 0, .k_refract = 1, .ior = n}, red_glow};
  scene.planes = {{{0, 1, 0}, 0, 0}, {{0, 1, 0}, 5, 1}};  // the surface y = 0 and a red ground at y = −5
  scene.camera = {.position = {0, -2, 0}, .target = {0, 0, 0}, .up = {0, 0, 1}, .half_angle = 1.1};
  scene.background = {0, 0, 1};
  for (RenderSettings s : all_variants()) {
    s.width = s.height = 80;
    const Film film = picture_of(scene, s);
    for (int y = 0; y < s.height; ++y) {
      for (int x = 0; x < s.width; ++x) {
        const double sine_outside = n * std::sqrt(1 - std::pow(through(s, 1.1, x, y).z, 2));
        if (std::abs(sine_outside - 1) < 1e-5) continue;
        // All of it either way: no light is lost at total reflection.
        ASSERT_NEAR(film.at(x, y).z, sine_outside < 1 ? 1 : 0, 1e-5);
        ASSERT_NEAR(film.at(x, y).x, sine_outside < 1 ? 0 : 1, 1e-5);
      }
    }
  }
}

TEST(closed_form, media_of_one_index_are_not_seen_however_they_overlap) {
  Scene scene;
  const Material clear{.k_ambient = 0, .k_diffuse = 0, .k_specular = 0, .k_refract = 1, .ior = 1.4};
  scene.materials = {clear, red_glow, clear};
  scene.meshes = {box({-2, -2, -4}, {2, 2, -2}, 0), box({-9, -9, -7}, {0.2, 9, -6}, 1)};
  scene.camera = {.position = {0.3, 0.2, 0}, .target = {0, 0, -1}, .half_angle = 0.5};
  Scene with_more = scene;
  with_more.spheres = {{{0, 0, -3}, 0.7, 2}, {{0.5, 0, -3}, 0.6, 0}};
  with_more.meshes.push_back(box({-1, -1, -3.5}, {1, 1, -3}, 2));
  for (RenderSettings s : all_variants()) {
    s.width = s.height = 40;
    s.depth = 20;
    const Film plain = picture_of(scene, s), full = picture_of(with_more, s);
    int differing = 0;
    for (size_t i = 0; i < plain.pixels().size(); ++i)
      differing += max_abs(plain.pixels()[i] - full.pixels()[i]) > 1e-5f;
    EXPECT_LE(differing, 2) << "but where rounding moves the wall's edge across a pixel's centre";
  }
}

TEST(closed_form, shadows_are_dimmed_by_what_the_light_passes) {
  Scene scene;
  const Material tinted{
      .k_ambient = 0, .k_diffuse = 0, .k_specular = 0, .k_refract = 0.8, .filter = {1, 0.5, 0.25}};
  scene.materials = {white, tinted, red_glow};
  scene.planes = {{{0, 0, 1}, 0, 0}};
  scene.lights = {{{0, 0, 10}, {1, 1, 1}}};
  scene.camera = {.position = {0, 0, 1}, .target = {0, 0, 0}, .half_angle = 0.1};
  Mesh sheet;
  sheet.vertices = {{-1, -1, 3}, {1, -1, 3}, {0, 2, 3}};
  sheet.triangles = {{0, 1, 2}};
  sheet.material = 1;
  const Mesh slab = box({-1, -1, 4}, {1, 1, 5}, 1);
  for (const RenderSettings& s : all_variants()) {
    const auto colour = [&](std::vector<Mesh> meshes) {
      scene.meshes = std::move(meshes);
      return picture_of(scene, s).at(0, 0);
    };
    EXPECT_NEAR(colour({}).x, 1, 1e-6);
    EXPECT_NEAR(colour({sheet}).x, 0.8, 1e-6);
    EXPECT_NEAR(colour({sheet}).y, 0.4, 1e-6);
    EXPECT_NEAR(colour({slab}).y, 0.16, 1e-6) << "in and out";
    EXPECT_NEAR(colour({slab, sheet}).z, 0.008, 1e-6);
    EXPECT_EQ(colour({slab, box({-1, -1, 6}, {1, 1, 7}, 2)}).x, 0) << "something opaque too";
    EXPECT_NEAR(colour({slab, box({-1, -1, 11}, {1, 1, 12}, 2)}).x, 0.64, 1e-6) << "behind the light";
  }
}

}  // namespace
}  // namespace raysweep
