// Rays know the media they are in, however these lie: nested, touching, overlapping. Case I1 of the failure
// catalogue.
#include "tracer/shade/media.h"

#include <gtest/gtest.h>

#include <random>

#include "tracer/accel/scalar.h"
#include "tracer/intersect/all.h"
#include "tracer/paths/interface.h"
#include "tracer/scene/shapes.h"
#include "tracer/shade/phong.h"
#include "tracer/shade/refraction.h"

namespace raysweep {
namespace {

TEST(medium_set, the_highest_rank_is_there_whatever_the_order_of_entering) {
  MediumSet set;
  EXPECT_EQ(set.top(), MediumSet::outside);
  for (const uint32_t rank : {3u, 7u, 1u, 7u}) set.enter(rank);
  EXPECT_EQ(set.top(), 7u);
  EXPECT_EQ(set.size(), 3u) << "entering twice is entering once";
  set.leave(7);
  set.leave(7);
  EXPECT_EQ(set.top(), 3u);
  set.leave(1);
  set.leave(3);
  EXPECT_TRUE(set.empty());
}

TEST(medium_set, deeper_nesting_than_it_holds_keeps_the_highest_and_empties_again) {
  MediumSet set;
  for (uint32_t rank = 0; rank < 40; ++rank) set.enter((rank * 17) % 40);
  EXPECT_EQ(set.size(), MediumSet::capacity);
  EXPECT_EQ(set.top(), 39u);
  EXPECT_TRUE(std::ranges::is_sorted(set, std::greater<>()));
  for (uint32_t rank = 0; rank < 40; ++rank) set.leave(rank);
  EXPECT_TRUE(set.empty());
}

Material glass(double ior, int priority = 0) {
  return {.k_reflect = 0.1, .k_refract = 0.9, .ior = ior, .priority = priority};
}

Mesh box(const Vec3d& lower, const Vec3d& upper, uint32_t material) {
  Mesh mesh;
  append_box(mesh, lower, upper);
  mesh.material = material;
  return mesh;
}

constexpr uint32_t ice = 0, air = 1, water = 2, wall = 3;

Scene base() {
  Scene scene;
  scene.materials = {glass(1.31), glass(1.0), glass(1.333), {}};
  scene.camera.position = {50, 40, 30};
  return scene;
}

/// Ways in which media lie to each other, by name.
Scene arrangement(const std::string& name) {
  Scene scene = base();
  const double ulp = std::nextafter(1.0f, 2.0f) - 1.0f;
  if (name == "nested") {
    scene.meshes = {box({-2, -2, -2}, {2, 2, 2}, ice), box({-1.5, -1.5, -1.5}, {1.5, 1.5, 1.5}, air),
                    box({-1.2, -1.4, -1.2}, {1.2, 0.3, 1.2}, water)};
    scene.spheres = {{{0.2, 0.8, 0.1}, 0.5, ice}};
  } else if (name == "touching") {
    // Water fills the hollow's lower half exactly: five faces with a gap of nothing.
    scene.meshes = {box({-2, -2, -2}, {2, 2, 2}, ice), box({-1, -1, -1}, {1, 1, 1}, air),
                    box({-1, -1, -1}, {1, 0.25, 1}, water), box({-1, -2, 2}, {1, 1, 3}, water)};
  } else if (name == "an ulp apart") {
    const auto near = static_cast<double>(1.0f - static_cast<float>(ulp));
    scene.meshes = {box({-2, -2, -2}, {2, 2, 2}, ice), box({-1, -1, -1}, {1, 1, 1}, air),
                    box({-near, -near, -near}, {near, 0.25, near}, water)};
    scene.spheres = {{{2.5 + 4 * ulp, 0, 0}, 0.5, water}, {{-2.5 + ulp, 0, 0}, 0.5, water}};
  } else if (name == "overlapping") {
    scene.meshes = {box({-2, -2, -2}, {2, 2, 2}, ice), box({-1, -1, -1}, {1, 1, 1}, air),
                    box({-1.0001, -1.0001, -1.0001}, {1.0001, 0.25, 1.0001}, water)};
    scene.spheres = {{{2.2, 0, 0}, 0.8, water}, {{0, 2.1, 0}, 0.5, ice}, {{0.2, 2.2, 0}, 0.5, ice}};
  } else if (name == "concentric spheres") {
    for (int i = 0; i < 12; ++i)
      scene.spheres.push_back({{0, 0, 0}, 2 - 0.15 * i, static_cast<uint32_t>(i % 3)});
    scene.spheres.push_back({{0, 0, 0}, 2, air});  // the outermost twice
  } else {  // tangent: a glass ball on an opaque floor and beside a glass box
    scene.planes = {{{0, 1, 0}, 1, wall}};
    scene.spheres = {{{0, 0, 0}, 1, ice}, {{0, 0, 0}, 0.7, air}, {{2, 0, 0}, 1, water}};
    scene.meshes = {box({-3, -1, -1}, {-1, 1, 1}, ice)};
  }
  return scene;
}

// A million paths an arrangement, float and double and each method together.
constexpr int path_count = 250'000;

struct WalkCounts {
  int paths = 0, ended_outside = 0, lost = 0, endless = 0;
};

/// Random paths from outside, at every interface reflected or refracted by chance, until they leave the
/// scene.
template <class T, class Method>
WalkCounts walk(const Scene& scene, int paths) {
  using Core = ScalarCore<T, Method>;
  const Core core(scene, "sah", 4);
  const Media media(scene);
  const InterfaceFinder<Core> finder(core, media);
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> uniform(-1, 1);
  WalkCounts counts;
  while (counts.paths < paths) {
    const Vec3d from =
        normalize(Vec3d(uniform(random), 0.8 * std::abs(uniform(random)), uniform(random))) * 9.0;
    const Vec3d to(3 * uniform(random), 2 * uniform(random), 2.5 * uniform(random));
    Ray<T> ray{Vec3<T>(from), normalize(Vec3<T>(to - from))};
    MediumSet inside;
    counts.paths++;
    int level = 0;
    for (; level < 2000; ++level) {
      const auto at = finder.next(ray, inside);
      if (!at) break;
      const T eta = static_cast<T>(media.ior(at->before) / media.ior(at->beyond));
      const auto bent = refract(ray.direction, at->surface.normal, eta);
      if (at->kind == InterfaceFinder<Core>::Kind::opaque || !bent || uniform(random) < -0.6) {
        ray = spawn(at->surface, normalize(reflect(ray.direction, at->surface.normal)), true, at->clearance);
        inside = at->before;
      } else {
        ray = spawn(at->surface, bent->direction, false, at->clearance);
        inside = at->beyond;
      }
    }
    if (level == 2000) {
      counts.endless++;
    } else if (inside.empty()) {
      counts.ended_outside++;
    } else {
      counts.lost++;
    }
  }
  return counts;
}

class Arrangements : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(media, Arrangements,
                         testing::Values("nested", "touching", "an ulp apart", "overlapping",
                                         "concentric spheres", "tangent"),
                         [](const auto& info) {
                           std::string name = info.param;
                           std::ranges::replace(name, ' ', '_');
                           return name;
                         });

TEST_P(Arrangements, i1_every_path_that_leaves_is_outside_of_all_media) {
  for_each_method([&](auto method) {
    for (const WalkCounts& counts : {walk<float, decltype(method)>(arrangement(GetParam()), path_count),
                                     walk<double, decltype(method)>(arrangement(GetParam()), path_count)}) {
      EXPECT_EQ(counts.lost, 0) << method.name << " of " << counts.paths;
      EXPECT_EQ(counts.endless, 0);
    }
  });
}

TEST(media, what_overlaps_is_ranked_by_priority_then_by_size) {
  Scene scene = base();
  scene.materials[air].priority = 1;
  scene.spheres = {{{0, 0, 0}, 1, water}, {{0, 0, 0}, 3, air}, {{0, 0, 0}, 2, ice}};
  const Media media(scene);
  EXPECT_GT(media.rank(1), media.rank(0)) << "priority before size";
  EXPECT_GT(media.rank(0), media.rank(2)) << "the smaller one is in the larger one";
}

TEST(media, a_camera_inside_knows_what_it_is_in) {
  Scene scene = arrangement("nested");
  for (const auto& [at, ior] : std::vector<std::pair<Vec3d, double>>{{{0, -1, 0}, 1.333},
                                                                     {{0.3, 0.8, 0.1}, 1.31},
                                                                     {{1.1, 1.2, 1.1}, 1.0},
                                                                     {{1.8, 0, 0}, 1.31},
                                                                     {{9, 0, 0}, 1}}) {
    scene.camera.position = at;
    const Media media(scene);
    EXPECT_EQ(media.ior(media.at_camera()), ior) << at.x << ' ' << at.y;
  }
  scene.planes = {{{0, 1, 0}, -20, water}};
  scene.camera.position = {30, 10, 0};
  EXPECT_EQ(Media(scene).ior(Media(scene).at_camera()), 1.333) << "under the surface y = 20";
}

TEST(media, winding_does_not_decide_what_is_inside) {
  Scene scene = arrangement("nested");
  for (auto& triangle : scene.meshes[0].triangles) std::swap(triangle[0], triangle[1]);
  const auto counts = walk<float, MollerTrumbore>(scene, 20'000);
  EXPECT_EQ(counts.lost, 0);
  scene.camera.position = {1.8, 0, 0};
  EXPECT_EQ(Media(scene).ior(Media(scene).at_camera()), 1.31);
}

TEST(media, a_mesh_that_does_not_close_is_a_sheet) {
  Scene scene = base();
  scene.meshes = {box({0, 0, 0}, {1, 1, 1}, ice)};
  EXPECT_EQ(Media(scene).crossing(0), Media::Crossing::against);
  scene.meshes[0].triangles.pop_back();
  EXPECT_EQ(Media(scene).crossing(0), Media::Crossing::sheet);
}

TEST(media, surfaces_that_touch_are_crossed_at_once) {
  const Scene scene = arrangement("touching");
  const ScalarCore<float, MollerTrumbore> core(scene, "sah", 4);
  const Media media(scene);
  const InterfaceFinder finder(core, media);
  // Down from the hollow's air: into the water, then straight from water into ice, with no film of air
  // between.
  Scene in_the_hollow = scene;
  in_the_hollow.camera.position = {0.3, 0.7, 0.2};
  MediumSet inside = Media(in_the_hollow).at_camera();
  Ray<float> down{{0.3f, 0.7f, 0.2f}, {0, -1, 0}};
  std::vector<double> iors;
  while (const auto at = finder.next(down, inside)) {
    iors.push_back(media.ior(at->beyond));
    down = spawn(at->surface, down.direction, false, at->clearance);
    inside = at->beyond;
  }
  EXPECT_EQ(iors, (std::vector<double>{1.333, 1.31, 1}));
}

}  // namespace
}  // namespace raysweep
