// Case F3 of the failure catalogue: a camera a hundred times as far away, its field of view a hundredth, sees
// what the near one sees.
#include <gtest/gtest.h>

#include "tests/tracer/edge_rays.h"
#include "tests/tracer/variants.h"
#include "tracer/scene/shapes.h"
#include "tracer/wide/isa.h"

namespace raysweep {
namespace {

constexpr double times = 100;

Scene from_far(Scene scene) {
  Camera& camera = scene.camera;
  camera.position = camera.target + (camera.position - camera.target) * times;
  camera.half_angle = std::atan(std::tan(camera.half_angle) / times);
  return scene;
}

/// Sheets of colours of their own that tile a square in front of the camera: flat, so that no perspective
/// tells its distance.
Scene flat_mosaic() {
  std::mt19937 random(7);
  Scene scene;
  constexpr int side = 6;
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      Mesh mesh = sheet(4, 0, random);
      for (Vec3f& v : mesh.vertices)
        v = Vec3f(Vec3d((v.x + 2.0 * x + 1) / side - 1, (v.y + 2.0 * y + 1) / side - 1, 0));
      mesh.material = static_cast<uint32_t>(scene.materials.size());
      const auto share = [&] { return static_cast<double>(random() % 64) / 64; };
      const double red = share(), green = share();
      scene.materials.push_back({.ambient = {red, green, share()}, .k_ambient = 1, .k_diffuse = 0});
      scene.meshes.push_back(std::move(mesh));
    }
  }
  // Seen a little turned and moved, so that edges pass between pixels, and from no axis' direction: of a
  // camera far away on an axis two numbers would be small, and round to little.
  Mesh view;
  view.vertices = {{0.013f, 0.029f, 4}, {0.013f, 0.029f, 0}, {0.1f, 1, 0}};
  scene.meshes.push_back(view);
  for (Mesh& mesh : scene.meshes) transform(mesh, {.scale = 1, .rotate = {31, 47, 0}, .translate = {}});
  view = scene.meshes.back();
  scene.meshes.pop_back();
  scene.camera = {
      .position = Vec3d(view.vertices[0]), .target = Vec3d(view.vertices[1]), .up = Vec3d(view.vertices[2])};
  scene.camera.half_angle = 0.2;
  return scene;
}

RenderSettings settings() {
  RenderSettings s;
  s.width = 96;
  s.height = 72;
  s.depth = 3;
  return s;
}

/// Every method in the core scalar, and in the core wide on each instruction set.
std::vector<RenderSettings> ways() {
  std::vector<RenderSettings> list;
  for (const Choice& method : methods()) {
    RenderSettings way = settings();
    way.method = method.name;
    list.push_back(way);
    way.core = "wide";
    for (const Isa& isa : built_isas()) {
      way.isa = isa.name;
      if (runs_here(isa.name)) list.push_back(way);
    }
  }
  return list;
}

struct Difference {
  size_t pixels = 0;  // by more than a thousandth of white
  double mean = 0;    // of white, over pixels and channels
};

Difference difference(const Film& a, const Film& b) {
  Difference found;
  for (size_t i = 0; i < a.pixels().size(); ++i) {
    const Vec3f by = a.pixels()[i] - b.pixels()[i];
    found.pixels += !(max_abs(by) <= 1e-3f);
    found.mean += static_cast<double>(std::abs(by.x) + std::abs(by.y) + std::abs(by.z));
  }
  found.mean /= 3 * static_cast<double>(a.pixels().size());
  return found;
}

/// The catalogue asks for a FLIP below 1e-3. The mean difference stands for it here; it weighs no pixel less
/// for its neighbours. Far away the origin is rounded to 2⁻¹⁶, a thousandth of a pixel: one pixel in a
/// thousand may see the other side of an edge.
TEST(far_camera, f3_sees_a_flat_picture_as_the_near_one_does) {
  const Scene near = flat_mosaic(), far = from_far(near);
  for (const RenderSettings& way : ways()) {
    const Film seen = picture_of(far, way);
    const Difference by = difference(seen, picture_of(near, way));
    EXPECT_LT(by.mean, 1e-3) << way.core << ' ' << way.method << ' ' << way.isa;
    EXPECT_LE(by.pixels, seen.pixels().size() / 1000) << way.core << ' ' << way.method << ' ' << way.isa;
  }
}

/// Of solid scenes the near picture is another one, but doubles show what the far one should be. Edges of
/// shadows and of mirror images move, too, by what rounds their origins.
TEST(far_camera, f3_in_float_sees_solid_scenes_as_in_double) {
  for (const BuiltInScene& built_in : scenes_up_to(brute_force_triangles)) {
    const Scene far = from_far(built_in.make(2));
    for (RenderSettings way : ways()) {
      if (way.core == "wide" && way.isa != best_isa()) continue;
      const Film in_float = picture_of(far, way);
      way.core = "scalar";
      way.precision = "double";
      const Difference by = difference(in_float, picture_of(far, way));
      EXPECT_LT(by.mean, 1e-3) << built_in.name << ' ' << way.method;
    }
  }
}

}  // namespace
}  // namespace raysweep
