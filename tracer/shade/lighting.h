// Materials and lights of a scene in one precision, and what lights do at a point.
#pragma once

#include <type_traits>
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
    for_each_light(material, point, normal, rays, [&](const LitRay& to_light) {
      const auto share = visible(to_light.ray, to_light.distance);
      if constexpr (std::is_same_v<decltype(share), const bool>) {
        if (share) sum += to_light.intensity * light(material, normal, to_light, from_eye);
      } else {
        sum += to_light.intensity * share * light(material, normal, to_light, from_eye);
      }
    });
    return sum;
  }

  /// A ray from a point to a light in front of its surface.
  struct LitRay {
    Ray<T> ray;
    T distance, cosine;
    Vec3<T> intensity;
  };

  /// Shows `visit` a ray to each light that may be seen from `point`, in the lights' order, and counts it.
  template <class Visit>
  void for_each_light(const Surfacing<T>& material, const Vec3<T>& point, const Vec3<T>& normal,
                      RayCounts& rays, Visit&& visit) const {
    if (!material.answers_light) return;
    for (const PointLight& light : lights_) {
      const Vec3<T> towards = light.position - point;
      const T distance = length(towards);
      const Vec3<T> to_light = towards * (1 / distance);
      const T cosine = dot(normal, to_light);
      // Behind the surface: dark without asking. So is a light in the very point.
      if (!(cosine > 0 && distance > 0)) continue;
      rays.shadow++;
      visit(LitRay{{point, to_light}, distance, cosine, light.intensity});
    }
  }

  /// What a light of intensity 1 adds if nothing is in its way.
  [[nodiscard]] static Vec3<T> light(const Surfacing<T>& material, const Vec3<T>& normal,
                                     const LitRay& to_light, const Vec3<T>& from_eye) {
    return phong(material, to_light.cosine, highlight(normal, to_light.ray.direction, from_eye));
  }

  struct PointLight {
    Vec3<T> position, intensity;
  };

  [[nodiscard]] const std::vector<PointLight>& lights() const { return lights_; }

 private:
  std::vector<Surfacing<T>> materials_;
  std::vector<PointLight> lights_;
};

}  // namespace raysweep
