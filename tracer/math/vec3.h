// Three numbers: a point, a direction or a colour.
#pragma once

#include <algorithm>
#include <cmath>

namespace raysweep {

template <class T>
struct Vec3 {
  T x{}, y{}, z{};

  constexpr Vec3() = default;
  constexpr Vec3(T a, T b, T c) : x(a), y(b), z(c) {}
  template <class U>
  constexpr explicit Vec3(const Vec3<U>& v)
      : x(static_cast<T>(v.x)), y(static_cast<T>(v.y)), z(static_cast<T>(v.z)) {}

  constexpr T operator[](int axis) const { return axis == 0 ? x : axis == 1 ? y : z; }

  constexpr Vec3& operator+=(const Vec3& b) { return *this = *this + b; }

  friend constexpr Vec3 operator+(const Vec3& a, const Vec3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend constexpr Vec3 operator-(const Vec3& a, const Vec3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend constexpr Vec3 operator*(const Vec3& a, const Vec3& b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }
  friend constexpr Vec3 operator*(const Vec3& a, T s) { return {a.x * s, a.y * s, a.z * s}; }
  friend constexpr Vec3 operator*(T s, const Vec3& a) { return a * s; }
  friend constexpr Vec3 operator-(const Vec3& a) { return {-a.x, -a.y, -a.z}; }
  friend constexpr bool operator==(const Vec3&, const Vec3&) = default;
};

template <class T>
[[nodiscard]] constexpr T dot(const Vec3<T>& a, const Vec3<T>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <class T>
[[nodiscard]] constexpr Vec3<T> cross(const Vec3<T>& a, const Vec3<T>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// The axis along which `a` is longest; of equal ones the last.
template <class T>
[[nodiscard]] int longest_axis(const Vec3<T>& a) {
  const T x = std::abs(a.x), y = std::abs(a.y), z = std::abs(a.z);
  return x > y && x > z ? 0 : y > z ? 1 : 2;
}

template <class T>
[[nodiscard]] T length(const Vec3<T>& a) {
  return std::sqrt(dot(a, a));
}

/// The vector of length 1 along `a`; `a` must not be zero.
template <class T>
[[nodiscard]] Vec3<T> normalize(const Vec3<T>& a) {
  return a * (T(1) / length(a));
}

template <class T>
[[nodiscard]] constexpr Vec3<T> min(const Vec3<T>& a, const Vec3<T>& b) {
  return {std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)};
}

template <class T>
[[nodiscard]] constexpr Vec3<T> max(const Vec3<T>& a, const Vec3<T>& b) {
  return {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)};
}

/// The largest absolute coordinate.
template <class T>
[[nodiscard]] T max_abs(const Vec3<T>& a) {
  return std::max({std::abs(a.x), std::abs(a.y), std::abs(a.z)});
}

template <class T>
[[nodiscard]] bool all_finite(const Vec3<T>& a) {
  return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z);
}

using Vec3d = Vec3<double>;
using Vec3f = Vec3<float>;

}  // namespace raysweep
