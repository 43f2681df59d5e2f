// What happens to a ray at the boundary of two media.
#pragma once

#include <cmath>
#include <optional>

#include "tracer/math/vec3.h"

namespace raysweep {

/// A refracted direction of length 1, and the cosines of both angles to the normal.
template <class T>
struct Refraction {
  Vec3<T> direction;
  T cos_incident, cos_transmitted;
};

/// Snell's law for `incident` (length 1) at `normal` (length 1, against `incident`), with `eta` = n1/n2:
/// `cos t = √(1 − η²(1 − c²))`, `T = ηI + (ηc − cos t)N`. Nothing: total internal reflection.
///
/// `1 − c²` is taken as `|I + cN|²`, the squared sine, and `1 − η² sin²` as a product of sum and difference:
/// neither cancels, so Snell's law holds to a few ulps up to the critical angle and at it.
template <class T>
[[nodiscard]] std::optional<Refraction<T>> refract(const Vec3<T>& incident, const Vec3<T>& normal, T eta) {
  const T cosine = -dot(normal, incident);
  const Vec3<T> tangent = incident + normal * cosine;
  const T sine = eta * length(tangent);
  if (!(sine < 1)) return std::nullopt;
  const T cos_transmitted = std::sqrt((1 - sine) * (1 + sine));
  return Refraction<T>{normalize(tangent * eta - normal * cos_transmitted), cosine, cos_transmitted};
}

/// The share of unpolarised light that a boundary reflects (Fresnel's equations): between media of `n1` and
/// `n2`, at an incident and a transmitted angle of these cosines. The same from both sides.
template <class T>
[[nodiscard]] T fresnel(T n1, T n2, T cos_incident, T cos_transmitted) {
  const T s = (n1 * cos_incident - n2 * cos_transmitted) / (n1 * cos_incident + n2 * cos_transmitted);
  const T p = (n2 * cos_incident - n1 * cos_transmitted) / (n2 * cos_incident + n1 * cos_transmitted);
  return (s * s + p * p) / 2;
}

}  // namespace raysweep
