// Materials and lights of a scene in one precision, and what lights do at a point.
#pragma once

#include <vector>

#include "tracer/math/ray.h"
#include "tracer/render_counts.h"
#include "tracer/shade/phong.h"

namespace raysweep {

template <class T>
class Lighting {
 public:
  explicit Lighting(const Scene& scene) {
    for (const Material& m : scene.materials) materials_.emplace_back(m, scene.ambient);
    for (const Light& l : scene.lights) lights_.push_back({Vec3<T>(l.position), Vec3<T>(l.intensity)});
  }

  [[nodiscard]] const Surfacing<T>& material(uint32_t index) const { return materials_[index]; }

  /// Ambient, diffuse and specular light from `point`, which must lie off the surface as spawned rays do,
  /// back along `from_eye`. `visible(ray, distance)` tells the share of a light, as a colour, that comes
  /// through from `distance` along a ray; or, where there is all or nothing, whether it does.
  template <class Visible>
  Vec3<T> at(const Surfacing<T>& material, const Vec3<T>& point, const Vec3<T>& normal,
             const Vec3<T>& from_eye, RayCounts& rays, Visible&& visible) const {
    Vec3<T> sum = material.ambient;
    if (!material.answers_light) return sum;
    for (const PointLight& light : lights_) {
      const Vec3<T> towards = light.position - point;
      const T distance = length(towards);
      const Vec3<T> to_light = towards * (1 / distance);
      const T cosine = dot(normal, to_light);
      // Behind the surface: dark without asking. So is a light in the very point.
      if (!(cosine > 0 && distance > 0)) continue;
      rays.shadow++;
      const auto share = visible(Ray<T>{point, to_light}, distance);
      if constexpr (std::is_same_v<decltype(share), const bool>) {
        if (share) sum += light.intensity * phong(material, normal, to_light, cosine, from_eye);
      } else {
        sum += light.intensity * share * phong(material, normal, to_light, cosine, from_eye);
      }
    }
    return sum;
  }

 private:
  struct PointLight {
    Vec3<T> position, intensity;
  };

  std::vector<Surfacing<T>> materials_;
  std::vector<PointLight> lights_;
};

}  // namespace raysweep
