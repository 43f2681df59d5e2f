// Scenes somewhere else.
#include "tracer/scene/moved.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tracer/render.h"
#include "tracer/scene/scenes.h"

namespace raysweep {
namespace {

Film picture(const Scene& scene) {
  RenderSettings settings;
  settings.width = settings.height = 24;
  settings.precision = "double";
  settings.method = "woop_watertight";
  Film film(settings.width, settings.height);
  (void)make_renderer(scene, settings)->render({0, 0, settings.width, settings.height}, film);
  return film;
}

double largest_difference(const Film& a, const Film& b) {
  double largest = 0;
  for (size_t i = 0; i < a.pixels().size(); ++i)
    largest = std::max(largest, static_cast<double>(max_abs(a.pixels()[i] - b.pixels()[i])));
  return largest;
}

/// By a power of two floats lose nothing of places that are multiples of 1/256; spheres, a plane, a mesh,
/// lights and the camera all must have gone along.
TEST(moved, a_scene_looks_the_same_from_its_camera) {
  Scene scene;
  scene.materials = {{}, {.k_reflect = 0.3}};
  scene.planes = {{{0, 1, 0}, 0.5, 0}};
  scene.spheres = {{{-0.5, 0.25, 0}, 0.5, 1}};
  Mesh mesh;
  mesh.vertices = {{0.25f, 0, 0}, {1.25f, 0, 0.5f}, {0.5f, 1.5f, 0.25f}};
  mesh.triangles = {{0, 1, 2}};
  scene.meshes = {mesh};
  scene.lights = {{{2, 4, 3}, {1, 1, 1}}};
  scene.camera = {.position = {0.5, 1, 4}, .target = {0, 0.25, 0}};
  const Film here = picture(scene);
  EXPECT_LT(largest_difference(here, picture(moved(scene, {1024, 2048, -4096}))), 1e-6);
  EXPECT_GT(largest_difference(here, picture({})), 0.1) << "there is something to be seen";
}

TEST(moved, every_place_is_a_float) {
  // 24 bits, counted: conversions there and back are what is to be tested.
  const auto has_24_bits = [](double value) {
    int exponent = 0;
    const double scaled = std::ldexp(std::frexp(value, &exponent), 24);
    return scaled == std::trunc(scaled);
  };
  const auto is_float = [&](const Vec3d& p) {
    return has_24_bits(p.x) && has_24_bits(p.y) && has_24_bits(p.z);
  };
  const Scene scene = moved(load_scene("studio"), {1e5, 1e5, 1e5});
  ASSERT_FALSE(scene.spheres.empty() || scene.lights.empty());
  for (const Sphere& sphere : scene.spheres) {
    EXPECT_TRUE(is_float(sphere.centre));
    EXPECT_TRUE(has_24_bits(sphere.radius));
  }
  for (const Light& light : scene.lights) EXPECT_TRUE(is_float(light.position));
  for (const Plane& plane : scene.planes) EXPECT_TRUE(has_24_bits(plane.offset));
  EXPECT_TRUE(is_float(scene.camera.position));
}

}  // namespace
}  // namespace raysweep
