// What a triangle's corners tell of its plane: computed of many triangles side by side, in loops that
// compilers turn into vectors.
#pragma once

#include <array>
#include <cmath>
#include <limits>

#include "tracer/intersect/intersector.h"

namespace raysweep {

template <class T>
inline constexpr T unit_roundoff = std::numeric_limits<T>::epsilon() / 2;

template <class T>
[[nodiscard]] constexpr T gamma_bound(int roundings) {
  const T nu = static_cast<T>(roundings) * unit_roundoff<T>;
  return nu / (1 - nu);
}

/// `|a|·|b|` summed over the axes: what bounds the rounding of a dot product.
template <class T>
[[nodiscard]] T abs_dot(const Vec3<T>& a, const Vec3<T>& b) {
  return std::abs(a.x * b.x) + std::abs(a.y * b.y) + std::abs(a.z * b.z);
}

/// By value: GCC makes branches of std::min and std::max over memory, and corners come in no order.
template <class T>
[[nodiscard]] constexpr T smaller(T a, T b) {
  return b < a ? b : a;
}
template <class T>
[[nodiscard]] constexpr T larger(T a, T b) {
  return a < b ? b : a;
}

/// Where a barycentric coordinate is below this, rays start too near to the edge opposite, which is `edge`
/// long. A coordinate of 1 is an altitude away from it. `area`: of the triangle, twice.
template <class T>
[[nodiscard]] T inset_from(double edge, double area, T clearance) {
  constexpr double clearances = 4;  // keeps right at faces that meet at 15° or more
  const double share = clearances * static_cast<double>(clearance) * edge / area;
  return static_cast<T>(smaller(0.25, share));
}

/// Edges and areas of `n` triangles, in double.
template <class T, size_t n>
struct TriangleExtents {
  T corner[9][n];       // x, y, z of A, of B, of C
  double edge[3][n];    // lengths of those opposite to each corner
  double longest[n];    // of them
  double others[n];     // the lengths of the other two, multiplied
  double normal[3][n];  // as long as the area is large, twice
  double area[n];       // twice

  explicit TriangleExtents(const std::array<Triangle<T>, n>& triangles) {
    for (size_t i = 0; i < n; ++i) {
      const auto& [a, b, c] = triangles[i];
      const T all[9] = {a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z};
      for (size_t row = 0; row < 9; ++row) corner[row][i] = all[row];
    }
    for (size_t i = 0; i < n; ++i) measure(i);
  }

 private:
  void measure(size_t i) {
    const auto at = [&](size_t first) {
      return Vec3d(corner[first][i], corner[first + 1][i], corner[first + 2][i]);
    };
    const Vec3d a = at(0), b = at(3), c = at(6), of_a = c - b, of_b = a - c, of_c = b - a;
    const double edge_a = length(of_a), edge_b = length(of_b), edge_c = length(of_c);
    edge[0][i] = edge_a;
    edge[1][i] = edge_b;
    edge[2][i] = edge_c;
    // Which edge is the longest nobody can guess: choices, not branches. The two shorter ones cancel least.
    const bool b_is_longer = edge_b > edge_a;
    const double of_two = b_is_longer ? edge_b : edge_a, other = b_is_longer ? edge_a : edge_b;
    const bool c_is_longest = edge_c > of_two;
    longest[i] = c_is_longest ? edge_c : of_two;
    others[i] = other * (c_is_longest ? of_two : edge_c);
    const auto choose = [&](double if_a, double if_b, double if_c) {
      const double if_not_c = b_is_longer ? if_b : if_a;
      return c_is_longest ? if_c : if_not_c;
    };
    const Vec3d u(choose(of_c.x, of_a.x, of_b.x), choose(of_c.y, of_a.y, of_b.y),
                  choose(of_c.z, of_a.z, of_b.z)),
        v(choose(-of_b.x, -of_c.x, -of_a.x), choose(-of_b.y, -of_c.y, -of_a.y),
          choose(-of_b.z, -of_c.z, -of_a.z));
    const Vec3d along = cross(u, v);
    normal[0][i] = along.x;
    normal[1][i] = along.y;
    normal[2][i] = along.z;
    area[i] = length(along);
  }
};

/// What hits and shading ask of a triangle besides its corners, and is not quickly found from them. All 0 of
/// one without area: it has no surface, no ray is on one side of it.
template <class T>
struct TriangleFace {
  Vec3<T> normal;
  T clearance;
  T inset;
};

/// Let m be the largest absolute coordinates of the corners, by axis, and all errors be taken along the
/// normal: × Σ|n|m. The point: 7 roundings of the barycentric sum (pbrt-v4, 6.8.5), 4 of coordinates that do
/// not sum to 1; the ray's start: 1; the signed distance: 4 on |P − A| ≤ 2m; the rounded normal: 1 on 2m; a
/// step from an edge: 2. Together 24. Where a thin triangle's cross product cancels, its normal errs by more:
/// 8u·|e||f|/|e×f| in double, over the triangle's extent; e and f are the two shorter edges.
template <class T, size_t n>
[[nodiscard]] std::array<TriangleFace<T>, n> faces_of(const std::array<Triangle<T>, n>& triangles) {
  const TriangleExtents<T, n> of(triangles);
  T normal[3][n], clearance[n], inset[n];
  for (size_t i = 0; i < n; ++i) {
    const bool has_area = of.area[i] > 0;
    const double inverse = 1 / of.area[i];
    for (size_t axis = 0; axis < 3; ++axis)
      normal[axis][i] = has_area ? static_cast<T>(of.normal[axis][i] * inverse) : 0;
    const auto largest = [&](size_t axis) {
      return larger(larger(std::abs(of.corner[axis][i]), std::abs(of.corner[axis + 3][i])),
                    std::abs(of.corner[axis + 6][i]));
    };
    const Vec3<T> m(largest(0), largest(1), largest(2));
    const double normal_error = 8 * unit_roundoff<double> * of.others[i] / of.area[i];
    const T error = gamma_bound<T>(24) * abs_dot(Vec3<T>(normal[0][i], normal[1][i], normal[2][i]), m) +
                    static_cast<T>(normal_error * of.longest[i]);
    clearance[i] = has_area ? error : 0;
    // The longest edge has the widest.
    inset[i] = has_area ? inset_from(of.longest[i], of.area[i], error) : 0;
  }
  std::array<TriangleFace<T>, n> faces;
  for (size_t i = 0; i < n; ++i)
    faces[i] = {{normal[0][i], normal[1][i], normal[2][i]}, clearance[i], inset[i]};
  return faces;
}

}  // namespace raysweep
