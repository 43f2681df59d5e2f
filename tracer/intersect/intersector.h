// What a ray–triangle method is: one header, one class template with the members of `Intersector`, one entry
// in all.h.
#pragma once

#include <concepts>
#include <optional>
#include <string_view>

#include "tracer/math/ray.h"

namespace raysweep {

/// Corners A, B, C.
template <class T>
struct Triangle {
  Vec3<T> a, b, c;

  /// With numbers of another type.
  template <class U>
  [[nodiscard]] Triangle<U> as() const {
    return {Vec3<U>(a), Vec3<U>(b), Vec3<U>(c)};
  }
};

/// Where a ray meets a triangle: at `origin + t·direction` = `(1−β−γ)A + βB + γC`.
template <class T>
struct TriangleHit {
  T t, beta, gamma;
};

/// A method. `prepare` runs once per triangle, `intersect` per test; a hit has t > 0, β ≥ 0, γ ≥ 0, β + γ ≤
/// 1, edges and corners included. NaN anywhere is a miss. `is_watertight`: no ray passes between triangles
/// that share an edge or a corner, whatever is rounded. A method that counts may have `visit_node()`, which
/// is called for each node whose children's boxes are compared with a ray.
template <class M, class T>
concept Intersector = requires(const Triangle<T>& triangle, const Ray<T>& ray,
                               const typename M::template Prepared<T>& prepared) {
  { M::name } -> std::convertible_to<std::string_view>;
  { M::summary } -> std::convertible_to<std::string_view>;
  { M::is_watertight } -> std::convertible_to<bool>;
  { M::prepare(triangle) } -> std::same_as<typename M::template Prepared<T>>;
  { M::intersect(ray, prepared) } -> std::same_as<std::optional<TriangleHit<T>>>;
};

}  // namespace raysweep
