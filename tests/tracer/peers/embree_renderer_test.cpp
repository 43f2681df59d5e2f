// Pictures with Embree as the core are ours, but for single pixels at edges.
#include "tracer/peers/embree_renderer.h"

#include <gtest/gtest.h>

#include "tests/tracer/variants.h"
#include "tracer/scene/scenes.h"

namespace raysweep {
namespace {

/// Counts its calls: a batch takes one second.
double seconds_of_calls() {
  static double calls = 0;
  return calls += 1;
}

EmbreeGeometry geometry_of(const Scene& scene, const EmbreeModes& modes) {
  const auto triangles = std::make_shared<EmbreeScene>(EmbreeBuild{"avx2", false, false});
  triangles->build(scene);
  return {std::make_shared<const EmbreeShapes>(scene), triangles, modes, seconds_of_calls};
}

RenderSettings small_settings() {
  RenderSettings settings;
  settings.width = 96;
  settings.height = 72;
  settings.subpixels = 2;
  settings.depth = 4;
  return settings;
}

size_t differing_pixels(const Film& a, const Film& b) {
  size_t differing = 0;
  for (size_t i = 0; i < a.pixels().size(); ++i) differing += a.pixels()[i] != b.pixels()[i];
  return differing;
}

TEST(embree_renderer, makes_our_picture_by_packets_of_any_width) {
  // Rays at edges, as in the tests of Embree's hits, and what follows from them.
  constexpr size_t most_differing = 5;
  const RenderSettings settings = small_settings();
  Scene on_floor = load_scene("chair-ball", 2);
  on_floor.planes = {{{0, 1, 0}, 0.01, 0}};
  for (const Scene& scene : {load_scene("chair-ball", 2), on_floor, load_scene("many-lights", 3)}) {
    const Film expected = picture_of(scene, settings);
    for (const unsigned width : {1u, 4u, 8u, 16u}) {
      for (const bool coherent : {false, true}) {
        const EmbreePackets packets{width, coherent};
        const auto renderer =
            make_embree_renderer(scene, settings, geometry_of(scene, {packets, packets, packets}));
        Film film(settings.width, settings.height);
        renderer->render({0, 0, settings.width, settings.height}, film);
        EXPECT_LE(differing_pixels(film, expected), most_differing)
            << scene.name << ", width " << width << ", coherent " << coherent;
      }
    }
  }
}

TEST(embree_renderer, sees_with_the_first_ray_what_we_see) {
  const Scene scene = load_scene("chair-ball", 2);
  const RenderSettings settings = small_settings();
  const auto ours = make_renderer(scene, settings);
  const auto embree = make_embree_renderer(scene, settings, geometry_of(scene, {}));
  size_t differing = 0;
  for (int y = 0; y < settings.height; ++y)
    for (int x = 0; x < settings.width; ++x) differing += ours->first_hit(x, y) != embree->first_hit(x, y);
  EXPECT_LE(differing, 3u);
}

TEST(embree_renderer, reads_the_clock_around_each_batch) {
  const Scene scene = load_scene("chair-ball", 2);
  RenderSettings settings = small_settings();
  settings.depth = 2;
  const auto renderer = make_embree_renderer(scene, settings, geometry_of(scene, {}));
  const auto workspace = renderer->make_workspace();
  EXPECT_EQ(seconds_in_embree(*workspace), 0);
  Film film(settings.width, settings.height);
  // A hundred samples, one round, in the picture's middle; two levels, on each a batch of either kind.
  renderer->render({43, 31, 10, 5}, film, *workspace);
  EXPECT_EQ(seconds_in_embree(*workspace), 4);
  renderer->render({43, 31, 10, 5}, film, *workspace);
  EXPECT_EQ(seconds_in_embree(*workspace), 8);
}

TEST(embree_renderer, has_a_surface_where_our_method_finds_no_hit) {
  Scene scene = load_scene("chair-ball", 1);
  Mesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.triangles = {{0, 1, 2}};
  scene.meshes = {mesh};
  const EmbreeShapes shapes(scene);
  const uint32_t id = shapes.first_triangle();
  const auto point_at = [&](float x, float y) {
    return shapes.surface({{x, y, 1}, {0, 0, -1}}, {1, id}).point;
  };
  // Held inside the triangle, and a few clearances away from its edges.
  EXPECT_LT(length(point_at(0.25f, -1e-6f) - Vec3f(0.25f, 0, 0)), 2e-5f);
  EXPECT_GT(point_at(0.25f, -1e-6f).y, 0);
  EXPECT_LT(length(point_at(2, -1) - Vec3f(1, 0, 0)), 2e-5f);
  EXPECT_TRUE(all_finite(shapes.surface({{0, 0, 1}, {1, 0, 0}}, {1, id}).point))
      << "in its plane's direction";
}

TEST(embree_renderer, hands_embree_no_ray_that_ends_it) {
  const Scene scene = load_scene("chair-ball", 1);
  const float nan = std::nanf("");
  for (const unsigned width : {1u, 4u, 8u, 16u}) {
    const EmbreePackets packets{width, true};
    const EmbreeCore core(scene, "sah", 4, geometry_of(scene, {packets, packets, packets}));
    RayBatch rays(2);
    rays.set(0, {{nan, 0, 0}, {0, 0, 1}});
    rays.set(1,
             {Vec3f(scene.camera.position), normalize(Vec3f(scene.camera.target - scene.camera.position))});
    HitBatch hits(2);
    EmbreeScratch scratch;
    core.closest(rays, hits, scratch);
    EXPECT_EQ(hits.id[0], no_hit_id);
    EXPECT_NE(hits.id[1], no_hit_id) << "its neighbour is traced";
    core.occluded(rays, hits, scratch);
    EXPECT_EQ(hits.id[0], no_hit_id);
    EXPECT_NE(hits.id[1], no_hit_id);
  }
}

TEST(embree_renderer, refuses_glass_and_packets_that_there_are_not) {
  const Scene glass = load_scene("cornell-glass", 1);
  EXPECT_THROW((void)make_embree_renderer(glass, small_settings(), geometry_of(glass, {})),
               std::invalid_argument);
  const Scene scene = load_scene("chair-ball", 1);
  const EmbreePackets odd{3, true};
  const auto renderer = make_embree_renderer(scene, small_settings(), geometry_of(scene, {odd, odd, odd}));
  EXPECT_THROW((void)renderer->first_hit(1, 1), std::invalid_argument);
}

}  // namespace
}  // namespace raysweep
