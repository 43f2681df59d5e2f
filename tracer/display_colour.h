// Colours of an sRGB display in the spaces that tell how different they look. All components are doubles;
// linear RGB is 0…1, the white that they are seen against is the display's own.
#pragma once

#include <cmath>

#include "tracer/math/vec3.h"

namespace raysweep {

/// A 3 × 3 matrix by columns.
struct ColourMatrix {
  Vec3d first, second, third;
  friend constexpr Vec3d operator*(const ColourMatrix& m, const Vec3d& v) {
    return m.first * v.x + m.second * v.y + m.third * v.z;
  }
  /// By Cramer's rule.
  [[nodiscard]] constexpr ColourMatrix inverse() const {
    const double scale = 1 / dot(first, cross(second, third));
    const Vec3d a = cross(second, third) * scale, b = cross(third, first) * scale,
                c = cross(first, second) * scale;
    return {{a.x, b.x, c.x}, {a.y, b.y, c.y}, {a.z, b.z, c.z}};
  }
};

/// XYZ of luminance 1 at the chromaticity (x, y).
[[nodiscard]] constexpr Vec3d xyz_of_chromaticity(double x, double y) { return {x / y, 1, (1 - x - y) / y}; }

/// CIE 1931: the white D65.
inline constexpr Vec3d display_white = xyz_of_chromaticity(0.31271, 0.32902);

namespace display_detail {

/// Columns are the primaries of IEC 61966-2-1, each so bright that together they make white.
constexpr ColourMatrix matrix_to_xyz() {
  const ColourMatrix primaries{xyz_of_chromaticity(0.64, 0.33), xyz_of_chromaticity(0.30, 0.60),
                               xyz_of_chromaticity(0.15, 0.06)};
  const Vec3d shares = primaries.inverse() * display_white;
  return {primaries.first * shares.x, primaries.second * shares.y, primaries.third * shares.z};
}

}  // namespace display_detail

inline constexpr ColourMatrix rgb_to_xyz = display_detail::matrix_to_xyz(), xyz_to_rgb = rgb_to_xyz.inverse();

/// Linear RGB as XYZ, each as a share of white's.
[[nodiscard]] constexpr Vec3d rgb_to_relative_xyz(const Vec3d& rgb) {
  const Vec3d xyz = rgb_to_xyz * rgb;
  return {xyz.x / display_white.x, xyz.y / display_white.y, xyz.z / display_white.z};
}

/// Luminance and two opponent colours, linear in XYZ (Flohr, Kolpatzik, Balasubramanian, Carrara, Bouman &
/// Allebach 1993): `(116·y − 16, 500·(x − y), 200·(y − z))`.
[[nodiscard]] constexpr Vec3d rgb_to_opponent(const Vec3d& rgb) {
  const Vec3d r = rgb_to_relative_xyz(rgb);
  return {116 * r.y - 16, 500 * (r.x - r.y), 200 * (r.y - r.z)};
}

[[nodiscard]] constexpr Vec3d opponent_to_rgb(const Vec3d& opponent) {
  const double y = (opponent.x + 16) / 116, x = y + opponent.y / 500, z = y - opponent.z / 200;
  return xyz_to_rgb * Vec3d(x * display_white.x, y * display_white.y, z * display_white.z);
}

/// CIE 1976 (L*, a*, b*): L* is 0 for black and 100 for white.
[[nodiscard]] inline Vec3d rgb_to_lab(const Vec3d& rgb) {
  constexpr double delta = 6.0 / 29;  // a straight line below delta³, lest black have an infinite slope
  const auto f = [](double t) {
    return t > delta * delta * delta ? std::cbrt(t) : t / (3 * delta * delta) + 4.0 / 29;
  };
  const Vec3d r = rgb_to_relative_xyz(rgb);
  const double x = f(r.x), y = f(r.y), z = f(r.z);
  return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

/// The more colourful, the brighter (Hunt 1952), as ꟻLIP has it: a* and b* times L*/100.
[[nodiscard]] constexpr Vec3d hunt_adjusted(const Vec3d& lab) {
  return {lab.x, 0.01 * lab.x * lab.y, 0.01 * lab.x * lab.z};
}

/// The distance of colours that are far apart (Abasi, Amani Tehran & Fairchild 2020): of lightness, and, as
/// the crow flies, of the rest.
[[nodiscard]] inline double hyab(const Vec3d& a, const Vec3d& b) {
  return std::abs(a.x - b.x) + std::hypot(a.y - b.y, a.z - b.z);
}

}  // namespace raysweep
