// Pictures in stages are the pictures of the scalar core, bit for bit, with the same counts of rays.
#include <gtest/gtest.h>

#include "tests/tracer/mixed_scene.h"
#include "tests/tracer/scene_sizes.h"
#include "tests/tracer/variants.h"
#include "tracer/wide/isa.h"

namespace raysweep {
namespace {

void expect_the_scalar_picture(const Scene& scene, RenderSettings settings) {
  settings.core = "scalar";
  RenderCounts expected_counts;
  const Film expected = picture_of(scene, settings, &expected_counts);
  settings.core = "wide";
  for (const Isa& isa : built_isas()) {
    if (!runs_here(isa.name)) continue;
    settings.isa = isa.name;
    RenderCounts counts;
    EXPECT_EQ(picture_of(scene, settings, &counts).hash(), expected.hash()) << scene.name << ' ' << isa.name;
    EXPECT_EQ(counts, expected_counts) << scene.name << ' ' << isa.name;
  }
}

TEST(staged, pictures_are_the_scalar_cores_on_every_scene_and_instruction_set) {
  for (const BuiltInScene& built_in : scenes_up_to(brute_force_triangles)) {
    for (const Choice& method : methods()) {
      RenderSettings settings;
      settings.width = 40;
      settings.height = 30;
      settings.subpixels = 3;
      settings.depth = 5;
      settings.method = method.name;
      expect_the_scalar_picture(built_in.make(2), settings);
    }
  }
}

TEST(staged, a_pixels_samples_may_fill_more_than_one_round) {
  RenderSettings settings;
  settings.width = 3;
  settings.height = 2;
  settings.subpixels = 1500;
  expect_the_scalar_picture(mixed_scene(), settings);
}

TEST(staged, paths_end_within_the_same_tolerance) {
  RenderSettings settings;
  settings.width = settings.height = 24;
  settings.depth = 64;
  settings.pixel_tolerance = 0.01;
  expect_the_scalar_picture(load_scene("many-lights", 3), settings);
}

TEST(staged, a_picture_in_tiles_is_the_picture) {
  const Scene scene = mixed_scene();
  RenderSettings settings;
  settings.width = 37;
  settings.height = 23;
  settings.core = "wide";
  const Film whole = picture_of(scene, settings);
  const auto renderer = make_renderer(scene, settings);
  Film film(settings.width, settings.height);
  for (int y = 0; y < settings.height; y += 5) {
    for (int x = 0; x < settings.width; x += 7)
      renderer->render({x, y, std::min(7, settings.width - x), std::min(5, settings.height - y)}, film);
  }
  EXPECT_EQ(film.hash(), whole.hash());
}

TEST(staged, other_precisions_are_refused) {
  RenderSettings settings;
  settings.core = "wide";
  settings.precision = "double";
  EXPECT_THROW((void)make_renderer(mixed_scene(), settings), std::invalid_argument);
  settings.precision = "float";
  settings.isa = "mmx";
  EXPECT_THROW((void)make_renderer(mixed_scene(), settings), std::invalid_argument);
}

}  // namespace
}  // namespace raysweep
