// A scene has no unit of length: drawn larger or smaller as a whole, it looks the same.
#include <gtest/gtest.h>

#include "tests/tracer/mixed_scene.h"
#include "tests/tracer/variants.h"
#include "tracer/wide/isa.h"

namespace raysweep {
namespace {

/// The scene with every length multiplied by `factor`.
Scene scaled(Scene scene, double factor) {
  for (Plane& plane : scene.planes) plane.offset *= factor;
  for (Sphere& sphere : scene.spheres) {
    sphere.centre = sphere.centre * factor;
    sphere.radius *= factor;
  }
  for (Mesh& mesh : scene.meshes) {
    for (Vec3f& vertex : mesh.vertices) vertex = Vec3f(Vec3d(vertex) * factor);
  }
  for (Light& light : scene.lights) light.position = light.position * factor;
  scene.camera.position = scene.camera.position * factor;
  scene.camera.target = scene.camera.target * factor;
  return scene;
}

std::vector<Scene> scenes() {
  std::vector<Scene> list{mixed_scene()};
  for (const BuiltInScene& scene : scenes_up_to(brute_force_triangles)) list.push_back(scene.make(2));
  return list;
}

/// The core scalar, and the core wide on each instruction set.
std::vector<RenderSettings> ways() {
  RenderSettings settings;
  settings.width = 48;
  settings.height = 36;
  settings.depth = 5;
  std::vector<RenderSettings> list{settings};
  settings.core = "wide";
  for (const Isa& isa : built_isas()) {
    settings.isa = isa.name;
    if (runs_here(isa.name)) list.push_back(settings);
  }
  return list;
}

std::string name_of(const Scene& scene, const RenderSettings& way, double factor) {
  return scene.name + " times " + std::to_string(factor) + ", " + way.core + ' ' + way.method + ' ' + way.isa;
}

/// They change exponents alone: every number is rounded as before.
TEST(scale, powers_of_two_change_no_bit) {
  for (const Scene& scene : scenes()) {
    for (RenderSettings way : ways()) {
      for (const Choice& method : methods()) {
        way.method = method.name;
        RenderCounts counts;
        const std::string picture = picture_of(scene, way, &counts).hash();
        for (const double factor : {0x1p-10, 0x1p20}) {
          RenderCounts scaled_counts;
          EXPECT_EQ(picture_of(scaled(scene, factor), way, &scaled_counts).hash(), picture)
              << name_of(scene, way, factor);
          EXPECT_EQ(scaled_counts, counts) << name_of(scene, way, factor);
        }
      }
    }
  }
}

/// By more than a thousandth of white.
size_t changed_pixels(const Film& a, const Film& b) {
  size_t count = 0;
  for (size_t i = 0; i < a.pixels().size(); ++i) {
    if (!(max_abs(a.pixels()[i] - b.pixels()[i]) <= 1e-3f)) count++;
  }
  return count;
}

/// Other factors round the shapes anew, by parts in 10 million: a pixel changes where its centre is that near
/// to an edge, a shadow's or a mirror image's too.
TEST(scale, powers_of_ten_change_a_pixel_in_a_thousand_at_most) {
  for (const Scene& scene : scenes()) {
    for (const RenderSettings& way : ways()) {
      const Film picture = picture_of(scene, way);
      for (const double factor : {1e-3, 1e6}) {
        EXPECT_LE(changed_pixels(picture_of(scaled(scene, factor), way), picture),
                  picture.pixels().size() / 1000)
            << name_of(scene, way, factor);
      }
    }
  }
}

}  // namespace
}  // namespace raysweep
