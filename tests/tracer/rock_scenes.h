// What is true of each scene whose rock is all that there is, or all but a room.
#pragma once

#include <gtest/gtest.h>

#include "tests/tracer/hit_rays.h"
#include "tracer/hash.h"
#include "tracer/scene/solid.h"

namespace raysweep {

/// Vertices and triangles, bit for bit.
inline std::string mesh_hash(const Mesh& mesh) {
  Hash hash;
  hash.add_bytes(mesh.vertices.data(), mesh.vertices.size() * sizeof(Vec3f));
  hash.add_bytes(mesh.triangles.data(), mesh.triangles.size() * sizeof(mesh.triangles[0]));
  return hash.text();
}

/// The centre sees the front of no triangle: the rock does not cut itself, and winds outwards. None is so
/// thin that its normal is rounding.
inline void expect_every_triangle_faces_outwards(const Mesh& rock) {
  for (const auto& [i, j, k] : rock.triangles) {
    const Vec3d a(rock.vertices[i]), b(rock.vertices[j]), c(rock.vertices[k]);
    ASSERT_GT(dot(a, cross(b, c)), 0);
    const double longest = std::max({length(b - a), length(c - b), length(a - c)});
    ASSERT_GT(length(cross(b - a, c - a)), 1e-3 * longest * longest);
  }
}

inline void expect_opaque_mirroring_triangles_alone(const Scene& scene) {
  EXPECT_TRUE(scene.planes.empty());
  EXPECT_TRUE(scene.spheres.empty());
  EXPECT_FALSE(has_transparency(scene));
  for (const Material& m : scene.materials) {
    EXPECT_EQ(problem_of(m), "");
    EXPECT_GE(m.k_reflect, 0.3);
    EXPECT_LE(m.k_reflect, 0.5);
    EXPECT_GT(std::min({m.k_ambient, m.k_diffuse, m.k_specular}), 0);
  }
}

/// The share of `count` rays of `kind` that hit.
template <class Core>
double hitting_share(const Scene& scene, const Core& core, const std::string& kind, size_t count) {
  size_t hits = 0;
  for (const auto& test : make_rays<float>(scene, core, kind, count))
    hits += core.closest(test.ray).has_value();
  return static_cast<double>(hits) / static_cast<double>(count);
}

/// Lumpy enough to be work: the rock fills the picture, and reflections meet it again.
inline void expect_a_full_picture_that_mirrors_itself(const Scene& scene) {
  const ScalarCore<float, MollerTrumbore> core(scene, "sah", 4);
  const double covered = hitting_share(scene, core, "primary", 5000);
  EXPECT_GT(covered, 0.6);
  EXPECT_LT(covered, 0.9);
  EXPECT_GT(hitting_share(scene, core, "reflected", 5000), 0.15);
}

/// Where brute force would take hours, hierarchies of different shape answer for each other.
template <class T>
void expect_agreeing_hierarchies(const Scene& scene, const std::vector<std::string>& kinds, size_t count) {
  const ScalarCore<T, MollerTrumbore> sah(scene, "sah", 4), median(scene, "median", 4),
      sbvh(scene, "sbvh", 4);
  for (const std::string& kind : kinds) {
    size_t differences = 0;
    for (const TestRay<T>& ray : make_rays<T>(scene, sah, kind, count))
      differences += !answers_agree(sah, median, ray) + !answers_agree(sah, sbvh, ray);
    EXPECT_EQ(differences, 0u) << scene.name << ' ' << kind;
  }
}

}  // namespace raysweep
