// Case N7 of the failure catalogue: meshes of random bits. They are built and traced like any other, and what
// is finite in them is hit as by brute force over the finite triangles alone.
#include <gtest/gtest.h>

#include <bit>

#include "tests/tracer/edge_rays.h"
#include "tests/tracer/wide/batches.h"
#include "tracer/accel/m11.h"
#include "tracer/intersect/all.h"

namespace raysweep {
namespace {

float any_bits(std::mt19937& random) { return std::bit_cast<float>(static_cast<uint32_t>(random())); }
Vec3f any_vector(std::mt19937& random) {
  const float x = any_bits(random), y = any_bits(random);
  return {x, y, any_bits(random)};
}

/// Triangles of random bits: one vertex in 85 has a number that is infinite or NaN, of the others any two are
/// powers of ten apart.
Mesh noise(uint32_t triangles, std::mt19937& random) {
  Mesh mesh;
  for (uint32_t i = 0; i < 3 * triangles; ++i) mesh.vertices.push_back(any_vector(random));
  for (uint32_t i = 0; i < triangles; ++i) mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  return mesh;
}

/// A closed mesh in which one number in 32 is garbage: of its vertices and of its triangles' corners. Of
/// random bits one in 256 is no finite number, so that some are put there on purpose.
Mesh damaged(std::mt19937& random) {
  constexpr float none[] = {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(),
                            -std::numeric_limits<float>::infinity()};
  Mesh mesh = rough_sphere(10, 10, random);
  for (Vec3f& vertex : mesh.vertices) {
    for (float* const number : {&vertex.x, &vertex.y, &vertex.z}) {
      if (random() % 32 == 0) *number = random() % 2 == 0 ? any_bits(random) : none[random() % 3];
    }
  }
  for (auto& triangle : mesh.triangles) {
    for (uint32_t& corner : triangle)
      if (random() % 32 == 0) corner = static_cast<uint32_t>(random() % mesh.vertices.size());
  }
  return mesh;
}

/// The finite triangles of a mesh, and which they were.
struct FinitePart {
  Mesh mesh;
  std::vector<uint32_t> ids;

  explicit FinitePart(const Mesh& whole) {
    mesh.vertices = whole.vertices;
    for (uint32_t i = 0; i < whole.triangles.size(); ++i) {
      const auto& [a, b, c] = whole.triangles[i];
      if (!all_finite(whole.vertices[a]) || !all_finite(whole.vertices[b]) || !all_finite(whole.vertices[c]))
        continue;
      mesh.triangles.push_back(whole.triangles[i]);
      ids.push_back(i);
    }
  }
};

/// Half of them at points of finite triangles, from near by and from anywhere; half are random bits.
std::vector<TestRay<float>> rays_at(const Mesh& finite, size_t count, std::mt19937& random) {
  std::uniform_real_distribution<double> uniform(0, 1);
  std::vector<TestRay<float>> rays;
  while (rays.size() < count) {
    const auto& [a, b, c] = finite.triangles[random() % finite.triangles.size()];
    const Vec3d corner(finite.vertices[a]), ab = Vec3d(finite.vertices[b]) - corner,
                                            ac = Vec3d(finite.vertices[c]) - corner;
    const double u = uniform(random), v = uniform(random) * (1 - u);
    const Vec3d target = corner + ab * u + ac * v;
    const double away = std::pow(10, 8 * uniform(random) - 2);
    const Vec3d origin = rays.size() % 4 == 0 ? Vec3d(0.1 * u, 0.1 * v, 0) : target + (ab - ac * v) * away;
    const Ray<float> ray{Vec3f(origin), Vec3f(normalize(target - origin))};
    rays.push_back({ray, random() % 4 == 0 ? 1e3f : std::numeric_limits<float>::infinity()});
    rays.push_back({{any_vector(random), any_vector(random)}, std::numeric_limits<float>::infinity()});
  }
  return rays;
}

template <class Method>
class Garbage {
 public:
  explicit Garbage(const Mesh& mesh) : mesh_(mesh), part_(mesh) {}

  /// That every hierarchy over the whole mesh answers `rays` as brute force does over its finite part; the
  /// hits among them.
  [[nodiscard]] size_t expect_agreement(const std::vector<TestRay<float>>& rays) const {
    const Scene scene = scene_of({mesh_});
    const ScalarCore<float, Method> oracle(scene_of({part_.mesh}), "none", 1);
    Answers expected(oracle, rays);
    size_t hits = 0;
    for (auto& hit : expected.nearest) {
      if (!hit) continue;
      hit->id = part_.ids[hit->id];
      ++hits;
    }
    for (const char* accel : {"none", "median", "sah", "sbvh"}) {
      const ScalarCore<float, Method> scalar(scene, accel, 2);
      EXPECT_EQ(differences(scalar, expected, rays), 0u) << accel << ' ' << Method::name;
      for_each_wide_core<Method>(scene, accel, 2, [&](const auto& core, std::string_view isa) {
        EXPECT_EQ(count_differences(core, expected, rays), 0u) << accel << ' ' << isa << ' ' << Method::name;
      });
    }
    const M11Core<float, Method> m11(scene, "median", 2);
    EXPECT_EQ(differences(m11, expected, rays), 0u) << "m11 " << Method::name;
    return hits;
  }

 private:
  template <class Core>
  [[nodiscard]] static size_t differences(const Core& core, const Answers& expected,
                                          const std::vector<TestRay<float>>& rays) {
    size_t count = 0;
    for (size_t i = 0; i < rays.size(); ++i) {
      const auto hit = core.closest(rays[i].ray, Hit<float>::start(), rays[i].t_max);
      const auto& right = expected.nearest[i];
      const bool same = hit ? right && hit->id == right->id && hit->t == right->t : !right;
      count += same && core.occluded(rays[i].ray, rays[i].t_max) == (expected.is_hidden[i] != 0) ? 0 : 1;
    }
    return count;
  }

  const Mesh& mesh_;
  FinitePart part_;
};

TEST(garbage, n7_of_triangles_of_random_bits_the_finite_ones_are_hit_as_by_brute_force) {
  for (const unsigned seed : {1u, 2u}) {
    std::mt19937 random(seed);
    const Mesh mesh = noise(100, random);
    const auto rays = rays_at(FinitePart(mesh).mesh, 1000, random);
    for_each_method([&](auto method) {
      EXPECT_GT(Garbage<decltype(method)>(mesh).expect_agreement(rays), 0u) << method.name;
    });
  }
}

TEST(garbage, n7_of_a_mesh_with_a_garbage_number_in_32_the_finite_triangles_are_hit_as_by_brute_force) {
  for (const unsigned seed : {1u, 2u}) {
    std::mt19937 random(seed);
    const Mesh mesh = damaged(random);
    const FinitePart part(mesh);
    ASSERT_LT(part.mesh.triangles.size(), mesh.triangles.size()) << "some are not finite";
    const auto rays = rays_at(part.mesh, 1000, random);
    for_each_method([&](auto method) {
      EXPECT_GT(Garbage<decltype(method)>(mesh).expect_agreement(rays), 100u) << method.name;
    });
  }
}

}  // namespace
}  // namespace raysweep
