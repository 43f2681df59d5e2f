// Rays by kind are what they are called.
#include "experiments/peers/rays.h"

#include <gtest/gtest.h>

#include <set>

#include "tracer/scene/scenes.h"
#include "tracer/scene/view.h"
#include "tracer/shade/phong.h"

namespace raysweep {
namespace {

constexpr int width = 96, height = 72;
constexpr std::array kinds{RayKind::primary, RayKind::shadow, RayKind::mirror, RayKind::diffuse};

class Rays : public testing::Test {
 public:
  Scene scene = triangles_alone(load_scene("chair-ball"));
  OracleCore core = make_oracle(scene);

  [[nodiscard]] RayBatch made(RayKind kind, uint64_t seed = 1) const {
    return make_rays(kind, scene, core, width, height, seed);
  }

  /// What the primary rays meet, in the order in which other rays leave it.
  [[nodiscard]] std::vector<std::pair<Ray<float>, Surface<float>>> hit_surfaces() const {
    std::vector<std::pair<Ray<float>, Surface<float>>> surfaces;
    const RayBatch primary = made(RayKind::primary);
    for (size_t i = 0; i < primary.size; ++i) {
      if (const auto hit = core.closest(primary.ray(i)))
        surfaces.emplace_back(primary.ray(i), core.primitives().surface(primary.ray(i), *hit));
    }
    return surfaces;
  }
};

TEST_F(Rays, have_length_1) {
  for (const RayKind kind : kinds) {
    const RayBatch rays = made(kind);
    ASSERT_GT(rays.size, 100u);
    for (size_t i = 0; i < rays.size; ++i) EXPECT_NEAR(length(rays.ray(i).direction), 1, 2e-6);
  }
}

TEST_F(Rays, go_through_the_centre_of_every_pixel_once) {
  const RayBatch rays = made(RayKind::primary);
  ASSERT_EQ(rays.size, size_t{width} * height);
  const View<float> view(scene.camera, width, height);
  const auto pixels = pixels_in_blocks(width, height);
  for (size_t i = 0; i < rays.size; ++i) {
    const Ray<float> ray =
        view.through(static_cast<float>(pixels[i].x) + 0.5f, static_cast<float>(pixels[i].y) + 0.5f);
    EXPECT_EQ(rays.ray(i).direction, ray.direction);
    EXPECT_EQ(rays.ray(i).origin, ray.origin);
    EXPECT_EQ(rays.t_max[i], std::numeric_limits<float>::infinity());
  }
}

TEST_F(Rays, of_shadows_end_at_the_light) {
  const RayBatch rays = made(RayKind::shadow);
  const Vec3f light(scene.lights.front().position);
  for (size_t i = 0; i < rays.size; ++i)
    EXPECT_LT(length(rays.ray(i).at(rays.t_max[i]) - light), 1e-5f * rays.t_max[i]);
}

TEST_F(Rays, start_where_primary_rays_hit_and_leave_upwards) {
  const auto surfaces = hit_surfaces();
  for (const RayKind kind : {RayKind::mirror, RayKind::diffuse}) {
    const RayBatch rays = made(kind);
    ASSERT_EQ(rays.size, surfaces.size()) << "one for each hit, none for what hits nothing";
    for (size_t i = 0; i < rays.size; ++i) {
      const Surface<float>& surface = surfaces[i].second;
      EXPECT_GT(dot(rays.ray(i).direction, surface.normal), 0);
      EXPECT_LT(length(rays.ray(i).origin - surface.point), 2 * surface.clearance);
      if (kind == RayKind::mirror) {
        const Vec3f reflected = reflect(surfaces[i].first.direction, surface.normal);
        EXPECT_GT(dot(rays.ray(i).direction, reflected), 0.9999f);
      }
    }
  }
}

// Lambert's cosine has the mean 2/3 and the deviation √(1/18); five deviations of the mean.
TEST_F(Rays, are_diffuse_by_the_cosine) {
  const auto surfaces = hit_surfaces();
  const RayBatch rays = made(RayKind::diffuse);
  double sum = 0;
  for (size_t i = 0; i < rays.size; ++i)
    sum += static_cast<double>(dot(rays.ray(i).direction, surfaces[i].second.normal));
  const auto count = static_cast<double>(rays.size);
  EXPECT_NEAR(sum / count, 2.0 / 3, 5 * std::sqrt(1 / 18.0 / count));
}

TEST_F(Rays, are_the_same_for_the_same_seed) {
  const auto directions = [](const RayBatch& rays) { return rays.direction_x; };
  EXPECT_EQ(directions(made(RayKind::diffuse)), directions(made(RayKind::diffuse)));
  EXPECT_NE(directions(made(RayKind::diffuse, 1)), directions(made(RayKind::diffuse, 2)));
}

TEST_F(Rays, of_shadows_need_a_light) {
  scene.lights.clear();
  EXPECT_EQ(made(RayKind::shadow).size, 0u);
}

TEST(pixels_in_blocks, visits_every_pixel_once_whatever_the_size) {
  for (const auto& [w, h] : {std::pair{1, 1}, {16, 16}, {17, 3}, {50, 37}}) {
    std::set<std::pair<int, int>> seen;
    for (const PixelPlace& p : pixels_in_blocks(w, h)) {
      EXPECT_TRUE(seen.emplace(p.x, p.y).second);
      EXPECT_TRUE(p.x >= 0 && p.x < w && p.y >= 0 && p.y < h);
    }
    EXPECT_EQ(seen.size(), static_cast<size_t>(w * h));
  }
}

TEST(pixels_in_blocks, fills_packets_of_16_with_blocks_of_4_by_4) {
  const auto pixels = pixels_in_blocks(32, 32);
  for (size_t i = 0; i < pixels.size(); ++i) {
    const PixelPlace& first = pixels[i / 16 * 16];
    EXPECT_EQ(first.x % 4, 0);
    EXPECT_EQ(first.y % 4, 0);
    EXPECT_EQ(pixels[i].x / 4, first.x / 4);
    EXPECT_EQ(pixels[i].y / 4, first.y / 4);
    EXPECT_EQ(pixels[i].x / 16, pixels[i / 256 * 256].x / 16);
    EXPECT_EQ(pixels[i].y / 16, pixels[i / 256 * 256].y / 16);
  }
}

}  // namespace
}  // namespace raysweep
