// What is to be seen: shapes, materials, lights, a camera. Plain data, in the precision it was written in.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "tracer/math/box.h"
#include "tracer/math/vec3.h"

namespace raysweep {

/// Linear red, green, blue; 1 is the brightest that a picture file holds.
using Colour = Vec3d;

/// Phong's local model (Morozov 2011), and what passes on: `k_ambient·ambient·I_a + Σ visible·I·
/// (k_diffuse·diffuse·N·L + k_specular·specular·(R·V)^exponent) + k_reflect·I_reflected +
/// k_refract·filter·I_refracted`. Colours and coefficients are ≥ 0, `k_reflect + k_refract` ≤ 1 and `filter`
/// ≤ 1: what passes on is never brighter than what came. A surface with `k_refract` > 0 bounds a medium; any
/// other is opaque.
struct Material {
  Colour ambient{1, 1, 1}, diffuse{1, 1, 1}, specular{1, 1, 1};
  double k_ambient = 0.1, k_diffuse = 0.7, k_specular = 0.3;
  double exponent = 32;
  double k_reflect = 0;
  double k_refract = 0;    // the share that passes through the surface
  Colour filter{1, 1, 1};  // the colour that passing through the surface once leaves of white
  double ior = 1.5;        // refractive index of the medium inside, against 1 outside of all media
  bool fresnel = false;    // the share `k_refract·F(angle)` is reflected instead of refracted
  int priority = 0;        // where media overlap, the highest one is there; of equals, the smallest object
};

/// Points X with `normal·X + offset = 0`; `normal` of length 1. Of a material that refracts, the medium is
/// where `normal·X + offset < 0`.
struct Plane {
  Vec3d normal;
  double offset;
  uint32_t material;
};

struct Sphere {
  Vec3d centre;
  double radius;
  uint32_t material;
};

/// An indexed triangle mesh; both sides are visible. Every index is below `vertices.size()`, every vertex
/// finite. Of a material that refracts, a closed mesh bounds a medium, whichever way its triangles wind; one
/// that does not close is a thin sheet, which rays pass without bending.
struct Mesh {
  std::string name;
  std::vector<Vec3f> vertices;
  std::vector<std::array<uint32_t, 3>> triangles;
  uint32_t material = 0;
};

/// A point light without fall-off.
struct Light {
  Vec3d position;
  Colour intensity;
};

/// Looks from `position` towards `target`; `half_angle` is half the vertical field of view, in radians.
struct Camera {
  Vec3d position, target, up{0, 1, 0};
  double half_angle = 0.35;
};

struct Scene {
  std::string name;
  std::vector<Material> materials;
  std::vector<Plane> planes;
  std::vector<Sphere> spheres;
  std::vector<Mesh> meshes;
  std::vector<Light> lights;
  Colour ambient{1, 1, 1};  // I_a
  Colour background;
  Camera camera;

  [[nodiscard]] size_t triangle_count() const;
};

/// What a renderer cannot do with `material`, as a sentence; empty if there is nothing.
[[nodiscard]] std::string problem_of(const Material& material);

/// Whether any shape has a material that refracts.
[[nodiscard]] bool has_transparency(const Scene& scene);

/// A fingerprint of all that a picture of the scene depends on: shapes, materials, lights, camera; names
/// apart.
[[nodiscard]] std::string scene_hash(const Scene& scene);

/// The box around all vertices of `mesh`.
[[nodiscard]] Box<double> bounds_of(const Mesh& mesh);

/// `count` lights on a dome of `radius` around `target`: a key light at the camera's left, then the rest,
/// dimmer, at the golden angle. Their intensities sum to 1 whatever the count, so that a sweep over lights
/// keeps the exposure.
[[nodiscard]] std::vector<Light> light_dome(int count, const Vec3d& target, double radius);

}  // namespace raysweep
