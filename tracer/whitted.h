// Backward ray tracing (Whitted 1980) over any core: nearest hit, shadow rays, one mirror bounce after the
// other.
#pragma once

#include "tracer/render.h"
#include "tracer/sample/pattern.h"
#include "tracer/scene/view.h"
#include "tracer/shade/phong.h"

namespace raysweep {

template <class Core>
class Whitted final : public Renderer {
 public:
  using T = typename Core::Real;

  Whitted(const Scene& scene, const RenderSettings& settings)
      : core_(scene, settings.accel, settings.leaf),
        view_(scene.camera, settings.width, settings.height),
        background_(scene.background),
        depth_(settings.depth) {
    for (const Material& m : scene.materials) materials_.emplace_back(m, scene.ambient);
    for (const Light& l : scene.lights) lights_.push_back({Vec3<T>(l.position), Vec3<T>(l.intensity)});
    for (const Subpixel& s : make_pattern(settings.pattern, settings.subpixels)) {
      pattern_.push_back({static_cast<T>(s.x), static_cast<T>(s.y)});
    }
  }

  RayCounts render(const Tile& tile, Film& film) const override {
    RayCounts rays;
    for (int y = tile.y; y < tile.y + tile.height; ++y) {
      for (int x = tile.x; x < tile.x + tile.width; ++x) film.at(x, y) = Vec3f(pixel(x, y, rays));
    }
    return rays;
  }

 private:
  struct PointLight {
    Vec3<T> position, intensity;
  };
  struct Offset {
    T x, y;
  };

  Vec3<T> pixel(int x, int y, RayCounts& rays) const {
    Vec3<T> sum;
    for (const Offset& o : pattern_)
      sum += trace(view_.through(static_cast<T>(x) + o.x, static_cast<T>(y) + o.y), rays);
    rays.primary += pattern_.size();
    return sum * (T(1) / static_cast<T>(pattern_.size()));
  }

  /// Follows a ray from mirror to mirror. A loop, not a recursion: any depth fits on any worker's stack.
  Vec3<T> trace(Ray<T> ray, RayCounts& rays) const {
    Vec3<T> sum;
    T weight = 1;
    for (int level = 1;; ++level) {
      const auto hit = core_.closest(ray);
      if (!hit) return sum + background_ * weight;
      const auto surface = core_.primitives().surface(ray, *hit);
      const Surfacing<T>& material = materials_[core_.primitives().material(hit->id)];
      // Rounding leaves the computed point within a few ulps of the distances that made it; a spawned ray
      // starts that far outside the surface.
      constexpr T ulps = 16 * std::numeric_limits<T>::epsilon();
      const T error = ulps * (max_abs(surface.point) + max_abs(ray.origin) + hit->t);
      const Vec3<T> outside = surface.point + surface.normal * error;
      sum += local(material, outside, surface.normal, ray.direction, rays) * weight;
      if (level == depth_ || material.reflect == 0) return sum;
      weight *= material.reflect;
      ray = {outside, normalize(reflect(ray.direction, surface.normal))};
      rays.reflected++;
    }
  }

  Vec3<T> local(const Surfacing<T>& material, const Vec3<T>& point, const Vec3<T>& normal,
                const Vec3<T>& from_eye, RayCounts& rays) const {
    Vec3<T> sum = material.ambient;
    for (const PointLight& light : lights_) {
      const Vec3<T> towards = light.position - point;
      const T distance = length(towards);
      const Vec3<T> to_light = towards * (1 / distance);
      const T cosine = dot(normal, to_light);
      if (!(cosine > 0)) continue;  // behind the surface: dark without asking
      rays.shadow++;
      if (core_.occluded({point, to_light}, distance)) continue;
      sum += light.intensity * phong(material, normal, to_light, cosine, from_eye);
    }
    return sum;
  }

  Core core_;
  View<T> view_;
  std::vector<Surfacing<T>> materials_;
  std::vector<PointLight> lights_;
  std::vector<Offset> pattern_;
  Vec3<T> background_;
  int depth_;
};

}  // namespace raysweep
