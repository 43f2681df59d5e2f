// Rays at the limits of their numbers, in every core and hierarchy: the cases N1 to N6 and V1 of the failure
// catalogue. The oracle is brute force.
#include <gtest/gtest.h>

#include <random>

#include "tests/tracer/edge_rays.h"
#include "tests/tracer/hit_rays.h"
#include "tracer/accel/m11.h"
#include "tracer/intersect/all.h"
#include "tracer/scene/shapes.h"

namespace raysweep {
namespace {

/// Unit boxes side by side: faces at whole numbers, many of them shared.
Scene boxes(int side) {
  std::vector<Mesh> meshes(1);
  for (int x = 0; x < side; ++x) {
    for (int y = 0; y < side; ++y) {
      for (int z = 0; z < side; ++z) append_box(meshes[0], Vec3d(x, y, z), Vec3d(x + 1, y + 1, z + 1));
    }
  }
  return scene_of(std::move(meshes));
}

template <class T>
class RobustRays : public testing::Test {
 protected:
  static constexpr T infinity = std::numeric_limits<T>::infinity();

  /// Calls `check(core, name)` with every core over every hierarchy.
  template <class Check>
  static void with_all_cores(const Scene& scene, Check&& check) {
    for_each_method([&](auto method) {
      using Method = decltype(method);
      check(ScalarCore<T, Method>(scene, "none", 1), "scalar none");
      check(ScalarCore<T, Method>(scene, "median", 4), "scalar median");
      check(ScalarCore<T, Method>(scene, "sah", 1), "scalar sah");
      check(ScalarCore<T, Method>(scene, "sbvh", 1), "scalar sbvh");
      check(M11Core<T, Method>(scene, "median", 4), "m11 median");
    });
  }

  /// Rays that hierarchies lose though brute force finds their hits, or find otherwise.
  template <class Rays>
  static int differences(const Scene& scene, const Rays& rays) {
    int count = 0;
    for_each_method([&](auto method) {
      using Method = decltype(method);
      const ScalarCore<T, Method> oracle(scene, "none", 1), sah(scene, "sah", 2), median(scene, "median", 2),
          sbvh(scene, "sbvh", 2);
      const M11Core<T, Method> m11(scene, "median", 2);
      for (const Ray<T>& ray : rays) {
        const TestRay<T> test{ray, infinity};
        count += !answers_agree(oracle, sah, test) + !answers_agree(oracle, median, test) +
                 !answers_agree(oracle, sbvh, test) + !answers_agree(oracle, m11, test);
      }
    });
    return count;
  }
};
using Reals = testing::Types<float, double>;
TYPED_TEST_SUITE(RobustRays, Reals);

TYPED_TEST(RobustRays, n1_a_ray_in_the_plane_of_a_face_meets_a_closed_box) {
  using T = TypeParam;
  this->with_all_cores(boxes(1), [](const auto& core, const char* name) {
    for (const T x : {T(0), T(1)}) {
      const auto hit = core.closest({{x, T(0.5), -1}, {0, 0, 1}});
      ASSERT_TRUE(hit) << name << " x = " << x;
      EXPECT_NEAR(hit->t, 1, 1e-5) << name;
      EXPECT_TRUE(core.occluded({{x, T(0.5), -1}, {0, 0, 1}}, 2)) << name;
    }
  });
}

TYPED_TEST(RobustRays, n2_a_negative_zero_is_a_zero) {
  using T = TypeParam;
  Mesh mesh;
  mesh.vertices = {{-1, -1, 1}, {1, -1, 1}, {0, 1, 1}, {-1, -1, 2.1f}, {1, -1, 2.1f}, {0, 1, 2.1f}};
  mesh.triangles = {{0, 1, 2}, {3, 4, 5}};
  this->with_all_cores(scene_of({mesh}), [](const auto& core, const char* name) {
    for (const T x : {T(0), -T(0)}) {
      for (const T y : {T(0), -T(0)}) {
        const auto hit = core.closest({{0, 0, 0}, {x, y, 1}});
        ASSERT_TRUE(hit) << name;
        EXPECT_EQ(hit->id, 0u) << name;
      }
    }
  });
}

TYPED_TEST(RobustRays, n3_origins_on_faces_lose_nothing) {
  using T = TypeParam;
  std::mt19937 random(3);
  std::uniform_int_distribution<int> whole(0, 4), axis(0, 2);
  std::uniform_real_distribution<T> uniform(0, 4);
  std::vector<Ray<T>> rays;
  for (int i = 0; i < 20'000; ++i) {
    const auto coordinate = [&] {
      return random() % 2 == 0 ? static_cast<T>(whole(random)) : uniform(random);
    };
    Vec3<T> direction;
    const T sign = random() % 2 == 0 ? T(1) : T(-1);
    const int along = axis(random);
    (along == 0 ? direction.x : along == 1 ? direction.y : direction.z) = sign;
    rays.push_back({{coordinate(), coordinate(), coordinate()}, direction});
    rays.push_back({{coordinate(), coordinate(), -1}, {0, 0, 1}});
  }
  EXPECT_EQ(this->differences(boxes(4), rays), 0);
  // And none of those that come from outside passes through.
  this->with_all_cores(boxes(4), [&](const auto& core, const char* name) {
    int missed = 0;
    for (const Ray<T>& ray : rays) missed += ray.origin.z < 0 && !core.closest(ray);
    EXPECT_EQ(missed, 0) << name;
  });
}

TYPED_TEST(RobustRays, n4_tiny_components_are_no_obstacle) {
  using T = TypeParam;
  this->with_all_cores(boxes(2), [](const auto& core, const char* name) {
    for (const T tiny : {T(1e-40), T(1e-17), T(-1e-40), T(-1e-17), std::numeric_limits<T>::denorm_min()}) {
      for (const T x : {T(0), T(0.5), T(1), T(2)}) {
        const auto hit = core.closest({{x, T(0.25), -1}, {tiny, -tiny, 1}});
        if (x == 0 && tiny < 0)
          continue;  // leaves the box sideways before it reaches it, or not: both are right
        if (x == 2 && tiny > 0) continue;
        ASSERT_TRUE(hit) << name << ' ' << x << ' ' << tiny;
        EXPECT_NEAR(hit->t, 1, 1e-5) << name;
      }
    }
  });
}

TYPED_TEST(RobustRays, n5_axis_parallel_rays_cost_no_more_tests_than_others) {
  using T = TypeParam;
  const Scene scene = boxes(12);
  const ScalarCore<T, CountingMethod> core(scene, "sah", 4);
  std::mt19937 random(5);
  std::uniform_real_distribution<T> uniform(0, 12);
  const auto tests = [&](const Vec3<T>& direction) {
    CountingMethod::tests = 0;
    for (int i = 0; i < 3000; ++i) (void)core.closest({{uniform(random), uniform(random), -1}, direction});
    return CountingMethod::tests;
  };
  const long slanted = tests(normalize(Vec3<T>(T(0.01), T(0.02), 1)));
  EXPECT_LE(tests({0, 0, 1}), 2.5 * static_cast<double>(slanted));
  EXPECT_LE(tests({T(1e-40), -T(0), 1}), 2.5 * static_cast<double>(slanted));
}

TYPED_TEST(RobustRays, n6_rays_that_are_not_finite_miss_without_a_test) {
  using T = TypeParam;
  const Scene scene = boxes(4);
  Scene with_plane = scene;
  with_plane.planes = {{{0, 1, 0}, 1, 0}};
  with_plane.spheres = {{{0, 0, 0}, 1, 0}};
  const ScalarCore<T, CountingMethod> scalar(with_plane, "sah", 4), brute(with_plane, "none", 4);
  const M11Core<T, CountingMethod> m11(with_plane, "median", 4);
  const Ray<T> good{{2, 2, -1}, {0, 0, 1}};
  for (const T bad : {std::numeric_limits<T>::quiet_NaN(), this->infinity, -this->infinity}) {
    for (int component = 0; component < 6; ++component) {
      Ray<T> ray = good;
      Vec3<T>& part = component < 3 ? ray.origin : ray.direction;
      (component % 3 == 0 ? part.x : component % 3 == 1 ? part.y : part.z) = bad;
      CountingMethod::tests = 0;
      EXPECT_FALSE(scalar.closest(ray));
      EXPECT_FALSE(brute.closest(ray));
      EXPECT_FALSE(m11.closest(ray));
      EXPECT_FALSE(scalar.occluded(ray, 9));
      EXPECT_FALSE(m11.occluded(ray, 9));
      EXPECT_EQ(CountingMethod::tests, 0);
    }
  }
  EXPECT_TRUE(scalar.closest(good));
}

TYPED_TEST(RobustRays, v1_at_edges_and_vertices_hierarchies_find_what_brute_force_finds) {
  using T = TypeParam;
  std::mt19937 random(11);
  std::uniform_real_distribution<double> uniform(0, 1);
  const Mesh sphere = rough_sphere(16, 16, random);
  std::vector<Ray<T>> rays;
  for (int i = 0; i < 30'000; ++i) {
    const auto& triangle = sphere.triangles[random() % sphere.triangles.size()];
    const Vec3d a(sphere.vertices[triangle[0]]), b(sphere.vertices[triangle[1]]);
    const Vec3d origin = Vec3d(uniform(random), uniform(random), uniform(random)) * 0.2;
    const Vec3d target = i % 3 == 0 ? a : a + (b - a) * uniform(random);
    rays.push_back({Vec3<T>(origin), normalize(Vec3<T>(target - origin))});
  }
  EXPECT_EQ(this->differences(scene_of({sphere}), rays), 0);
}

/// One ray's hits one after the other are those that brute force shows, in order, whatever comes before.
TYPED_TEST(RobustRays, hits_can_be_had_one_after_the_other) {
  using T = TypeParam;
  Scene scene = boxes(3);
  scene.planes = {{{0, 0, 1}, -1, 0}, {{0, 0, 1}, -1, 0}};
  scene.spheres = {{{1.5, 1.5, 1.5}, 1, 0}, {{1.5, 1.5, 1.5}, 1, 0}};
  std::mt19937 random(2);
  std::uniform_real_distribution<T> uniform(0, 3);
  for (int i = 0; i < 300; ++i) {
    const Ray<T> ray{{uniform(random), uniform(random), -1},
                     normalize(Vec3<T>(uniform(random) - T(1.5), uniform(random) - T(1.5), T(2)))};
    this->with_all_cores(scene, [&](const auto& core, const char* name) {
      std::vector<Hit<T>> walked, visited;
      for (auto hit = core.closest(ray); hit; hit = core.closest(ray, *hit)) walked.push_back(*hit);
      EXPECT_FALSE(core.visit_hits(ray, this->infinity, [&](const Hit<T>& hit) {
        visited.push_back(hit);
        return false;
      }));
      std::ranges::sort(visited, [](const Hit<T>& a, const Hit<T>& b) { return a.before(b); });
      ASSERT_EQ(walked.size(), visited.size()) << name;
      for (size_t k = 0; k < walked.size(); ++k) {
        EXPECT_EQ(walked[k].id, visited[k].id);
        EXPECT_EQ(walked[k].t, visited[k].t);
      }
      EXPECT_GE(walked.size(), 2u) << "planes lie in the way";
    });
  }
}

}  // namespace
}  // namespace raysweep
