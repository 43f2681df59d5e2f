// What touches, overlaps or is thinner than floats can tell looks the same in float and in double, to the eye
// and in the light's way.
#include <gtest/gtest.h>

#include <random>

#include "tests/tracer/variants.h"
#include "tracer/accel/surface.h"
#include "tracer/scene/shapes.h"
#include "tracer/scene/solid.h"

namespace raysweep {
namespace {

Material clear(const Colour& filter, double k_refract = 0.9, double ior = 1.0) {
  return {
      .k_ambient = 0, .k_diffuse = 0, .k_specular = 0, .k_refract = k_refract, .filter = filter, .ior = ior};
}

Mesh box(const Vec3d& lower, const Vec3d& upper, uint32_t material, const Vec3d& rotate = {},
         const Vec3d& translate = {}) {
  Mesh mesh;
  append_box(mesh, lower, upper);
  transform(mesh, {.scale = 1, .rotate = rotate, .translate = translate});
  mesh.material = material;
  return mesh;
}

RenderSettings settings_of(const char* precision, int side = 100) {
  RenderSettings s;
  s.width = s.height = side;
  s.depth = 12;
  s.precision = precision;
  return s;
}

/// Renders in both precisions; how many pixels differ by more than `by`.
size_t pixels_that_differ(const Scene& scene, float by, RenderCounts* counts = nullptr) {
  const Film in_float = picture_of(scene, settings_of("float"), counts);
  const Film in_double = picture_of(scene, settings_of("double"));
  size_t count = 0;
  for (size_t i = 0; i < in_float.pixels().size(); ++i)
    count += max_abs(in_float.pixels()[i] - in_double.pixels()[i]) > by;
  return count;
}

constexpr Colour red(1, 0.2, 0.2), blue(0.2, 0.2, 1);

/// Two blocks that share the face y = 0.3, turned so that no coordinate is round.
Scene touching_blocks() {
  Scene scene;
  scene.materials = {
      clear(red, 0.9, 1.3), clear(blue, 0.9, 1.5), {.k_ambient = 0, .k_diffuse = 1, .k_specular = 0}};
  scene.meshes = {box({-5, -0.5, -5}, {5, 0.3, 5}, 0, {10, 20, 5}),
                  box({-5, 0.3, -5}, {5, 1, 5}, 1, {10, 20, 5})};
  scene.background = {1, 1, 1};
  scene.camera = {.position = {0.3, 9, 0.4}, .target = {0, 0, 0}, .up = {0, 0, 1}, .half_angle = 0.15};
  return scene;
}

TEST(touching, the_face_between_two_media_is_that_of_the_higher_one_in_every_pixel) {
  RenderCounts counts;
  EXPECT_LE(pixels_that_differ(touching_blocks(), 1e-4f, &counts), 2u);
  const Film film = picture_of(touching_blocks(), settings_of("float"));
  // Three faces are paid for: in, across, out. The smaller block is the higher medium, and is paid for twice.
  const Vec3f middle = film.at(50, 50);
  EXPECT_NEAR(middle.z, 0.9 * 0.9 * 0.9 * 0.2, 1e-4);
  EXPECT_NEAR(middle.x, 0.9 * 0.9 * 0.9 * 0.04, 1e-4);
  EXPECT_EQ(counts.left_out.lost_media, 0u);
}

TEST(touching, a_light_pays_as_the_eye_does) {
  Scene scene = touching_blocks();
  // A white floor below, lit through both blocks, and seen from between.
  scene.planes = {{{0, 1, 0}, 3, 2}};
  scene.lights = {{scene.camera.position, {1, 1, 1}}};
  scene.camera = {.position = {3, -2.2, 0.4}, .target = {0, -3, 0}, .half_angle = 0.1};
  EXPECT_LE(pixels_that_differ(scene, 1e-3f), 5u) << "no speckle";
  const Film film = picture_of(scene, settings_of("float"));
  for (const Vec3f& p : film.pixels()) {
    ASSERT_GT(p.z, 0.05f);
    // In by the blue block, across as blue, out by the red one.
    EXPECT_NEAR(p.x / p.z, 0.04 / 0.2, 1e-4) << "each of the three surfaces once";
  }
}

TEST(touching, a_sheet_on_a_face_colours_what_passes) {
  for (const double gap : {0.0, 1e-7, 0.01}) {
    Scene scene;
    scene.materials = {clear({1, 1, 1}, 1, 1.2), clear(red, 1)};
    Mesh sheet;
    const auto z = static_cast<float>(1 + gap);
    sheet.vertices = {{-9, -9, z}, {9, -9, z}, {9, 9, z}, {-9, 9, z}};
    sheet.triangles = {{0, 1, 2}, {0, 2, 3}};
    sheet.material = 1;
    scene.meshes = {box({-9, -9, -1}, {9, 9, 1}, 0), sheet};
    scene.background = {1, 1, 1};
    scene.camera = {.position = {0.1, 0.2, 9}, .target = {0, 0, 0}, .half_angle = 0.3};
    for (const char* precision : {"float", "double"}) {
      const Film film = picture_of(scene, settings_of(precision, 40));
      for (const Vec3f& p : film.pixels()) {
        ASSERT_NEAR(p.x, 1, 1e-5) << gap;
        ASSERT_NEAR(p.y, 0.2, 1e-5) << gap;
      }
    }
  }
}

TEST(touching, a_pane_thinner_than_floats_can_tell_is_a_sheet_with_two_faces) {
  for (const double offset : {0.0, 100.0, 1000.0}) {
    const Vec3d at(offset, offset, offset);
    Scene scene;
    scene.materials = {clear({1, 0.5, 1}, 0.9, 1.5)};
    scene.meshes = {box({-2, -2, -5e-5}, {2, 2, 5e-5}, 0, {17, 23, 0}, at)};
    scene.background = {1, 1, 1};
    scene.camera = {.position = at + Vec3d(0, 0, 10), .target = at, .half_angle = 0.3};
    RenderCounts counts;
    const Film film = picture_of(scene, settings_of("float"), &counts);
    EXPECT_EQ(counts.left_out.lost_media, 0u) << offset;
    const Vec3f middle = film.at(48, 52);
    EXPECT_NEAR(middle.x, 0.81, 1e-4) << offset;
    EXPECT_NEAR(middle.y, 0.2025, 1e-4) << offset;
  }
}

TEST(touching, overlapping_parts_of_one_mesh_are_one_body) {
  Scene two;
  two.materials = {clear({1, 1, 1}, 1, 1.5), {.ambient = {1, 0, 0}, .k_ambient = 1, .k_diffuse = 0}};
  two.meshes = {box({-1, -1, -1}, {0.4, 0.8, 1}, 0, {10, 30, 0}),
                box({-0.2, -0.9, -0.8}, {1, 1, 0.9}, 0, {10, 30, 0})};
  two.planes = {{{0.6, 0, 0.8}, 4, 1}};
  two.background = {0.5, 0.7, 1};
  two.camera = {.position = {0.2, 0.5, 6}, .target = {0, 0, 0}, .half_angle = 0.3};
  Scene one = two;
  Mesh& mesh = one.meshes[0];
  const auto first = static_cast<uint32_t>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), two.meshes[1].vertices.begin(), two.meshes[1].vertices.end());
  for (const auto& [a, b, c] : two.meshes[1].triangles)
    mesh.triangles.push_back({a + first, b + first, c + first});
  one.meshes.pop_back();
  EXPECT_EQ(picture_of(one, settings_of("float")).hash(), picture_of(two, settings_of("float")).hash());
}

TEST(solids, a_sheet_with_two_windings_bounds_nothing) {
  Mesh sheet;
  sheet.vertices = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0.2f}, {0, 1, 0}};
  sheet.triangles = {{0, 1, 2}, {0, 2, 3}, {2, 1, 0}, {3, 2, 0}};
  EXPECT_FALSE(is_closed(sheet));
  Mesh both = box({0, 0, 0}, {1, 1, 1}, 0);
  EXPECT_TRUE(is_closed(both));
  both.triangles.pop_back();
  EXPECT_FALSE(is_closed(both));
}

TEST(solids, parts_are_told_apart_by_place_not_by_index) {
  Mesh mesh = box({0, 0, 0}, {1, 1, 1}, 0);
  append_box(mesh, {5, 0, 0}, {6, 1, 1});
  // As STL has it: no two triangles share a vertex by number.
  Mesh loose;
  for (const auto& triangle : mesh.triangles) {
    const auto first = static_cast<uint32_t>(loose.vertices.size());
    for (const uint32_t i : triangle) loose.vertices.push_back(mesh.vertices[i]);
    loose.triangles.push_back({first, first + 1, first + 2});
  }
  for (const Mesh* m : {&mesh, &loose}) {
    const auto parts = connected_parts(*m);
    ASSERT_EQ(parts.size(), 2u);
    for (const auto& part : parts) {
      EXPECT_EQ(part.size(), 12u);
      EXPECT_TRUE(is_closed(part_of(*m, part)));
      EXPECT_NEAR(signed_volume(part_of(*m, part)), 1, 1e-6);
    }
  }
}

/// A mirror floor of 10 × 10 in `count` strips, far from the origin, with a ball above it.
Scene striped_floor(int count) {
  const float at = 1000;
  Scene scene;
  scene.materials = {{.k_ambient = 0.1, .k_diffuse = 0.5, .k_reflect = 0.5}, {.diffuse = {1, 0, 0}}};
  Mesh floor;
  for (int i = 0; i < count; ++i) {
    const float low = at - 5 + 10 * static_cast<float>(i) / static_cast<float>(count);
    const float high = at - 5 + 10 * static_cast<float>(i + 1) / static_cast<float>(count);
    const auto first = static_cast<uint32_t>(floor.vertices.size());
    floor.vertices.insert(floor.vertices.end(),
                          {{at - 5, 0, low}, {at + 5, 0, low}, {at + 5, 0, high}, {at - 5, 0, high}});
    floor.triangles.push_back({first, first + 2, first + 1});
    floor.triangles.push_back({first, first + 3, first + 2});
  }
  scene.meshes = {floor};
  scene.spheres = {{{at, 1.5, at}, 1, 1}};
  scene.background = {0.5, 0.7, 1};
  scene.camera = {.position = {at, 4, at + 9}, .target = {at, 0, at}, .half_angle = 0.35};
  scene.lights = {{{at + 3, 8, at + 3}, {1, 1, 1}}};
  return scene;
}

TEST(slivers, a_floor_in_thin_strips_is_shaded_where_it_was_hit) {
  EXPECT_LE(pixels_that_differ(striped_floor(1000), 0.01f), 60u)
      << "the outlines of shadow and mirror image only";
}

TEST(slivers, points_stay_within_clearances_of_where_the_ray_hit) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<float> uniform(0, 1);
  for (int i = 0; i < 200'000; ++i) {
    // From fat to a ten-thousandth as high as long, at coordinates up to 1000.
    const float height = std::pow(10.0f, -4 * uniform(random)), at = std::pow(10.0f, 3 * uniform(random));
    const Vec3f a(at, uniform(random), at), b = a + Vec3f(uniform(random), uniform(random), 1),
                                            c = a + Vec3f(uniform(random) * height, height, uniform(random));
    const TriangleShape<float> shape({a, b, c});
    const float beta = uniform(random), gamma = uniform(random) * (1 - beta);
    const Vec3d exact = Vec3d(a) + (Vec3d(b) - Vec3d(a)) * static_cast<double>(beta) +
                        (Vec3d(c) - Vec3d(a)) * static_cast<double>(gamma);
    const auto surface = shape.surface({{}, {0, 0, 1}}, beta, gamma);
    ASSERT_LE(length(Vec3d(surface.point) - exact), 13 * shape.clearance + 1e-6 * static_cast<double>(at));
  }
}

}  // namespace
}  // namespace raysweep
