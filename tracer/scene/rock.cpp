#include "tracer/scene/rock.h"

#include "tracer/scene/geodesic.h"

namespace raysweep {

namespace {

/// Mixes a lattice point: its neighbours get bits that look unrelated. Primes from Teschner et al. 2003,
/// the rounds of MurmurHash3's last step.
uint32_t mix(uint32_t x, uint32_t y, uint32_t z, uint32_t seed) {
  uint32_t h = (x * 73856093u) ^ (y * 19349663u) ^ (z * 83492791u) ^ (seed * 0x9e3779b9u);
  h = (h ^ (h >> 16)) * 0x85ebca6bu;
  h = (h ^ (h >> 13)) * 0xc2b2ae35u;
  return h ^ (h >> 16);
}

/// The dot product of `d` with one of the twelve vectors from a cube's middle to those of its edges.
double slope(uint32_t hash, const Vec3d& d) {
  const uint32_t edge = hash % 12;
  const double u = edge < 8 ? d.x : d.y, v = edge < 4 ? d.y : d.z;
  return (edge & 1 ? -u : u) + (edge & 2 ? -v : v);
}

/// From 0 to 1 with first and second derivatives 0 at both ends.
double fade(double t) { return t * t * t * (t * (t * 6 - 15) + 10); }

/// Not std::lerp, whose rounding is left to the library.
double mix_linearly(double a, double b, double t) { return a + (b - a) * t; }

}  // namespace

double gradient_noise(const Vec3d& p, uint32_t seed) {
  const Vec3d low(std::floor(p.x), std::floor(p.y), std::floor(p.z)), d = p - low;
  const auto whole = [](double v) { return static_cast<uint32_t>(static_cast<int32_t>(v)); };
  const uint32_t x = whole(low.x), y = whole(low.y), z = whole(low.z);
  const auto corner = [&](uint32_t i, uint32_t j, uint32_t k) {
    return slope(mix(x + i, y + j, z + k, seed), d - Vec3d(i, j, k));
  };
  const double u = fade(d.x), v = fade(d.y), w = fade(d.z);
  const auto along_x = [&](uint32_t j, uint32_t k) {
    return mix_linearly(corner(0, j, k), corner(1, j, k), u);
  };
  return mix_linearly(mix_linearly(along_x(0, 0), along_x(1, 0), v),
                      mix_linearly(along_x(0, 1), along_x(1, 1), v), w);
}

Mesh make_rock(const Rock& rock) {
  // Noise is 0 on its lattice, and the coarse lattice lies in all finer ones: each octave is moved elsewhere.
  const Vec3d elsewhere(0.37, 0.71, 0.53);
  Mesh mesh;
  append_geodesic(mesh, rock.frequency, [&](const Vec3d& direction) {
    double radius = 1, height = rock.height, waves = rock.lumps;
    for (int octave = 0; octave < rock.octaves; ++octave) {
      const auto seed = rock.seed + static_cast<uint32_t>(octave);
      radius += height * gradient_noise(direction * waves + elsewhere * (octave + 1.0), seed);
      height *= rock.roughness;
      waves *= 2;
    }
    return Vec3d(rock.stretch.x * direction.x, rock.stretch.y * direction.y, rock.stretch.z * direction.z) *
           radius;
  });
  return mesh;
}

}  // namespace raysweep
