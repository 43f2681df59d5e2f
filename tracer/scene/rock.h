// Rocks: spheres that smooth noise pushes in and out. Deterministic, bit for bit on every machine.
#pragma once

#include "tracer/scene/scene.h"

namespace raysweep {

/// A sphere of radius 1 around the origin, whose surface moves along the radius: the centre sees every point
/// of it. Of several octaves of noise, each is twice as fine as the one before.
struct Rock {
  int frequency;  // of its geodesic sphere: 20·frequency² triangles
  int octaves;
  double lumps;      // how many waves of the first octave the radius holds
  double height;     // how far the first octave pushes at most, about
  double roughness;  // the height of each octave against the one before
  Vec3d stretch{1, 1, 1};
  uint32_t seed = 0;
};

/// Additions, multiplications, divisions and square roots in double, rounded to float at the end: IEEE 754
/// says what they give, which it does not of sines and powers.
[[nodiscard]] Mesh make_rock(const Rock& rock);

/// Gradient noise (Perlin 2002): smooth to the second derivative, about −1 to 1, 0 where all coordinates are
/// whole. Coordinates are within ±2³⁰.
[[nodiscard]] double gradient_noise(const Vec3d& p, uint32_t seed);

}  // namespace raysweep
