// Materials and lights of a scene in one precision, and what lights do at a point.
#pragma once

#include <vector>

#include "tracer/render_counts.h"
#include "tracer/shade/phong.h"

namespace raysweep {

/// `transparent`: shadow rays are dimmed by what they pass instead of cut off; scenes in which all is opaque
/// do without.
template <class Core, bool transparent>
class Lighting {
 public:
  using T = typename Core::Real;

  explicit Lighting(const Scene& scene) {
    for (const Material& m : scene.materials) materials_.emplace_back(m, scene.ambient);
    for (const Light& l : scene.lights) lights_.push_back({Vec3<T>(l.position), Vec3<T>(l.intensity)});
  }

  [[nodiscard]] const Surfacing<T>& material(uint32_t index) const { return materials_[index]; }

  /// Ambient, diffuse and specular light from `point`, which must lie off the surface as spawned rays do,
  /// back along `from_eye`.
  Vec3<T> at(const Core& core, const Surfacing<T>& material, const Vec3<T>& point, const Vec3<T>& normal,
             const Vec3<T>& from_eye, RayCounts& rays) const {
    Vec3<T> sum = material.ambient;
    for (const PointLight& light : lights_) {
      const Vec3<T> towards = light.position - point;
      const T distance = length(towards);
      const Vec3<T> to_light = towards * (1 / distance);
      const T cosine = dot(normal, to_light);
      if (!(cosine > 0)) continue;  // behind the surface: dark without asking
      rays.shadow++;
      const Ray<T> shadow{point, to_light};
      Vec3<T> intensity = light.intensity;
      if constexpr (transparent) {
        if (core.occluded_by_opaque(shadow, distance)) continue;
        intensity = intensity * transmitted(core, shadow, distance);
      } else {
        if (core.occluded(shadow, distance)) continue;
      }
      sum += intensity * phong(material, normal, to_light, cosine, from_eye);
    }
    return sum;
  }

 private:
  struct PointLight {
    Vec3<T> position, intensity;
  };

  /// What is left of a light after everything between: each surface takes its share (Morozov 2011, 3.1.2), in
  /// the order in which the ray meets them.
  Vec3<T> transmitted(const Core& core, const Ray<T>& ray, T distance) const {
    Vec3<T> share(1, 1, 1);
    auto hit = core.closest(ray, Hit<T>::start(), distance);
    while (hit && hit->t < distance) {
      const Surfacing<T>& passed = materials_[core.primitives().material(hit->id)];
      share = share * passed.filter * passed.refract;
      hit = core.closest(ray, *hit, distance);
    }
    return share;
  }

  std::vector<Surfacing<T>> materials_;
  std::vector<PointLight> lights_;
};

}  // namespace raysweep
