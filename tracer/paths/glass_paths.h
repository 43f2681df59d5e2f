// Paths through scenes in which something is transparent: every hit may send out a reflected and a refracted
// ray.
#pragma once

#include "tracer/paths/interface.h"
#include "tracer/paths/pending_rays.h"
#include "tracer/settings.h"
#include "tracer/shade/lighting.h"
#include "tracer/shade/radiance_bound.h"
#include "tracer/shade/refraction.h"

namespace raysweep {

template <class Core>
class GlassPaths {
 public:
  using T = typename Core::Real;
  /// Storage kept from sample to sample.
  struct Scratch {
    PendingRays<T> pending;
    std::vector<Hit<T>> hits;
  };

  GlassPaths(const Scene& scene, const RenderSettings& settings)
      : lighting_(scene),
        media_(scene),
        bound_(scene, settings.depth),
        background_(scene.background),
        depth_(settings.depth),
        ray_limit_(settings.branches),
        tolerance_(settings.pixel_tolerance) {}

  /// What the camera's `ray` brings back: rays are traced heaviest first until none is left, until what is
  /// left cannot matter, or until the sample has traced as many rays as it may.
  ///
  /// The tolerance's proof: `rest` bounds what all waiting rays together would add to any channel, each by
  /// its weight × the bound of its levels. Ending when that is within the tolerance loses at most that, once
  /// a sample; a pixel is the mean of its samples.
  Vec3<T> trace(const Core& core, const Ray<T>& ray, RenderCounts& counts, Scratch& scratch) const {
    PendingRays<T>& pending = scratch.pending;
    Sample sample{core, counts, scratch, {}, 0};
    pending.clear();
    add(sample, {ray, {1, 1, 1}, 1, false, media_.at_camera()});
    for (int traced = 0; !pending.empty(); ++traced) {
      const bool negligible = tolerance_ > 0 && traced > 0 && sample.rest <= tolerance_;
      if (negligible || traced == ray_limit_) {
        (negligible ? counts.left_out.by_tolerance : counts.left_out.by_branches) += pending.size();
        counts.left_out.bound = std::max(counts.left_out.bound, sample.rest);
        break;
      }
      const PendingRay<T> next = pending.take();
      sample.rest = pending.empty() ? 0 : sample.rest - bound_of(next);
      if (next.level > 1) (next.refracted ? counts.rays.refracted : counts.rays.reflected)++;
      follow(sample, next);
    }
    return sample.colour;
  }

 private:
  /// A sample in the making.
  struct Sample {
    const Core& core;
    RenderCounts& counts;
    Scratch& scratch;
    Vec3<T> colour;
    double rest;  // what all pending rays can add at most
  };

  [[nodiscard]] double bound_of(const PendingRay<T>& ray) const {
    return static_cast<double>(max_abs(ray.weight)) * bound_.at(depth_ - ray.level + 1);
  }

  void add(Sample& sample, const PendingRay<T>& ray) const {
    if (!(max_abs(ray.weight) > 0)) return;
    if (ray.level > depth_) {
      sample.counts.left_out.by_depth++;
      return;
    }
    sample.scratch.pending.add(ray);
    sample.rest += bound_of(ray);
  }

  void follow(Sample& sample, PendingRay<T> path) const {
    const auto found = InterfaceFinder<Core>(sample.core, media_).next(path.ray, path.media);
    if (!found) {
      sample.colour += background_ * path.weight;
      if (!media_.may_end_in(path.media)) sample.counts.left_out.lost_media++;
      return;
    }
    const Surface<T>& surface = found->surface;
    const Surfacing<T>& material = lighting_.material(sample.core.primitives().material(found->hit.id));
    const Vec3<T> direction = path.ray.direction;
    const Ray<T> mirrored =
        spawn(surface, normalize(reflect(direction, surface.normal)), true, found->clearance);
    const auto share = [&](const Ray<T>& to_light, T distance) {
      return light_share(sample, to_light, distance, found->before);
    };
    const Vec3<T> local =
        lighting_.at(material, mirrored.origin, surface.normal, direction, sample.counts.rays, share);
    sample.colour += local * path.weight;
    T reflected = material.reflect, refracted = found->is_opaque ? 0 : material.refract;
    if (refracted > 0) {
      const Vec3<T> onwards = pass(direction, *found, material, reflected, refracted);
      add(sample, {spawn(surface, onwards, false, found->clearance),
                   path.weight * material.filter * refracted, path.level + 1, true, found->beyond});
    }
    add(sample, {mirrored, path.weight * reflected, path.level + 1, false, found->before});
  }

  /// What comes through of a light at `distance` along `ray`, which starts in `inside`: nothing through
  /// anything opaque; else every surface between two media, and every sheet, takes its share (Morozov
  /// 2011, 3.1.2), in the order in which the ray meets them. A ray through an edge meets both its triangles,
  /// and pays once.
  Vec3<T> light_share(Sample& sample, const Ray<T>& ray, T distance, MediumSet inside) const {
    const auto& primitives = sample.core.primitives();
    std::vector<Hit<T>>& hits = sample.scratch.hits;
    hits.clear();
    const bool blocked = sample.core.visit_hits(ray, distance, [&](const Hit<T>& hit) {
      hits.push_back(hit);
      return primitives.is_opaque(hit.id);
    });
    if (blocked) return {};
    std::ranges::sort(hits, [](const Hit<T>& a, const Hit<T>& b) { return a.before(b); });
    Vec3<T> share(1, 1, 1);
    Hit<T> last_sheet = Hit<T>::start();
    for (const Hit<T>& hit : hits) {
      bool pays = true;
      if (media_.crossing(hit.id) == Media::Crossing::sheet) {
        const bool same_place = hit.t <= last_sheet.t * (1 + gamma_bound<T>(16));
        pays = !(same_place && media_.rank(hit.id) == media_.rank(last_sheet.id));
        last_sheet = hit;
      } else {
        const uint32_t before = inside.top();
        media_.cross(inside, hit.id, primitives.surface(ray, hit).against);
        pays = inside.top() != before;
      }
      const Surfacing<T>& passed = lighting_.material(primitives.material(hit.id));
      if (pays) share = share * passed.filter * passed.refract;
    }
    return share;
  }

  /// The direction behind the interface; moves between the shares `reflected` and `refracted` what is
  /// reflected at this angle: all, beyond the critical one.
  Vec3<T> pass(const Vec3<T>& direction, const Interface<T>& at, const Surfacing<T>& material, T& reflected,
               T& refracted) const {
    const T n1 = static_cast<T>(media_.ior(at.before)), n2 = static_cast<T>(media_.ior(at.beyond));
    if (n1 == n2) return direction;
    const auto bent = refract(direction, at.surface.normal, n1 / n2);
    const T share = !bent              ? T(1)
                    : material.fresnel ? fresnel(n1, n2, bent->cos_incident, bent->cos_transmitted)
                                       : T(0);
    reflected += refracted * share;
    refracted *= 1 - share;
    return bent ? bent->direction : direction;
  }

  Lighting<T> lighting_;
  Media media_;
  RadianceBound bound_;
  Vec3<T> background_;
  int depth_, ray_limit_;
  double tolerance_;
};

}  // namespace raysweep
