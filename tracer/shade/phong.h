// The local model: what a surface point sends towards the eye by itself, lit by point lights (Phong 1975).
#pragma once

#include "tracer/scene/scene.h"

namespace raysweep {

/// A material in one precision, coefficients multiplied into the colours.
template <class T>
struct Surfacing {
  Vec3<T> ambient, diffuse, specular;
  Vec3<T> filter;
  T exponent, reflect, refract;
  bool fresnel;
  bool answers_light;  // whether lights change anything

  Surfacing(const Material& m, const Colour& ambient_light)
      : ambient(m.ambient * ambient_light * m.k_ambient),
        diffuse(m.diffuse * m.k_diffuse),
        specular(m.specular * m.k_specular),
        filter(m.filter),
        exponent(static_cast<T>(m.exponent)),
        reflect(static_cast<T>(m.k_reflect)),
        refract(static_cast<T>(m.k_refract)),
        fresnel(m.fresnel),
        answers_light(max_abs(diffuse) > 0 || max_abs(specular) > 0) {}
};

/// `I − 2N(N·I)`.
template <class T>
[[nodiscard]] Vec3<T> reflect(const Vec3<T>& incident, const Vec3<T>& normal) {
  return incident - normal * (2 * dot(normal, incident));
}

/// The cosine between a light's mirrored ray and the eye. Both directions have length 1.
template <class T>
[[nodiscard]] T highlight(const Vec3<T>& normal, const Vec3<T>& to_light, const Vec3<T>& from_eye) {
  return dot(reflect(-to_light, normal), -from_eye);
}

/// What one visible light adds: diffuse and specular. `cosine` is N·L > 0.
template <class T>
[[nodiscard]] Vec3<T> phong(const Surfacing<T>& material, T cosine, T highlight) {
  Vec3<T> sum = material.diffuse * cosine;
  if (highlight > 0) sum += material.specular * std::pow(highlight, material.exponent);
  return sum;
}

}  // namespace raysweep
