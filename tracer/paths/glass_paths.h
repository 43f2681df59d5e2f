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
  /// The tolerance's proof: a waiting ray adds to any channel at most its weight × the bound of the levels
  /// that it has left (RadianceBound); `rest` is the sum of that over all waiting rays. Ending when it is
  /// within the tolerance loses at most that, once a sample; a pixel is the mean of its samples.
  Vec3<T> trace(const Core& core, const Ray<T>& ray, RenderCounts& counts, Scratch& scratch) const {
    Sample sample{core, counts, scratch, {}, 0};
    PendingRays<T>& pending = scratch.pending;
    pending.clear();
    add(sample, {ray, {1, 1, 1}, 1, false, media_.at_camera()});
    for (int traced = 0; !pending.empty(); ++traced) {
      const bool may_end = tolerance_ > 0 && traced > 0 && sample.rest_about <= 2 * tolerance_;
      if (may_end || traced == ray_limit_) {
        const double rest = rest_of(pending);
        sample.rest_about = rest;
        if ((may_end && rest <= tolerance_) || traced == ray_limit_) {
          leave_out(counts.left_out, traced == ray_limit_, pending.size(), rest);
          break;
        }
      }
      const PendingRay<T> next = pending.take();
      sample.rest_about -= bound_of(next);
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
    double rest_about;  // kept up by adding and subtracting: says when to sum anew, and no more
  };

  [[nodiscard]] double bound_of(const PendingRay<T>& ray) const {
    return static_cast<double>(max_abs(ray.weight)) * bound_.at(depth_ - ray.level + 1);
  }

  [[nodiscard]] double rest_of(const PendingRays<T>& pending) const {
    double rest = 0;
    pending.for_each([&](const PendingRay<T>& ray) { rest += bound_of(ray); });
    return rest;
  }

  static void leave_out(LeftOut& left_out, bool by_limit, size_t count, double rest) {
    (by_limit ? left_out.by_branches : left_out.by_tolerance) += count;
    left_out.bound = std::max(left_out.bound, rest);
  }

  void add(Sample& sample, const PendingRay<T>& ray) const {
    if (!(max_abs(ray.weight) > 0)) return;
    if (ray.level > depth_) {
      sample.counts.left_out.by_depth++;
      return;
    }
    sample.scratch.pending.add(ray);
    sample.rest_about += bound_of(ray);
  }

  void follow(Sample& sample, PendingRay<T> path) const {
    const auto found = InterfaceFinder<Core>(sample.core, media_).next(path.ray, path.media);
    if (!found) {
      sample.colour += background_ * path.weight;
      const bool lost = !media_.may_end_in(path.media) || path.media.overflowed();
      sample.counts.left_out.lost_media += lost ? 1 : 0;
      return;
    }
    path.weight = path.weight * also_passed(sample.core, *found);
    const Surface<T>& surface = found->surface;
    const Surfacing<T>& material = surfacing(sample.core, found->hit.id);
    const Vec3<T> direction = path.ray.direction;
    const Ray<T> mirrored =
        spawn(surface, normalize(reflect(direction, surface.normal)), true, found->clearance);
    const auto share = [&](const Ray<T>& to_light, T distance) {
      return light_share(sample, to_light, distance, found->before);
    };
    const Vec3<T> local =
        lighting_.at(material, mirrored.origin, surface.normal, direction, sample.counts.rays, share);
    sample.colour += local * path.weight;
    const bool is_opaque = found->kind == Interface<T>::Kind::opaque;
    T reflected = material.reflect, refracted = is_opaque ? 0 : material.refract;
    if (refracted > 0) {
      const Vec3<T> onwards = pass(direction, *found, material, reflected, refracted);
      add(sample, {spawn(surface, onwards, false, found->clearance),
                   path.weight * material.filter * refracted, path.level + 1, true, found->beyond});
    }
    add(sample, {mirrored, path.weight * reflected, path.level + 1, false, found->before});
  }

  [[nodiscard]] const Surfacing<T>& surfacing(const Core& core, uint32_t primitive) const {
    return lighting_.material(core.primitives().material(primitive));
  }

  /// What sheets in the same place as the interface leave of white.
  [[nodiscard]] Vec3<T> also_passed(const Core& core, const Interface<T>& at) const {
    Vec3<T> share(1, 1, 1);
    for (uint32_t i = 0; i < at.also_count; ++i) {
      const Surfacing<T>& passed = surfacing(core, at.also_passed[i]);
      share = share * passed.filter * passed.refract;
    }
    return share;
  }

  /// What comes through of a light at `distance` along `ray`, which starts in `inside`: nothing through
  /// anything opaque; else every interface that a path would find takes its share (Morozov 2011, 3.1.2), in
  /// the order in which the ray meets them.
  Vec3<T> light_share(Sample& sample, const Ray<T>& ray, T distance, MediumSet inside) const {
    std::vector<Hit<T>>& hits = sample.scratch.hits;
    hits.clear();
    const bool blocked = sample.core.visit_hits(ray, distance, [&](const Hit<T>& hit) {
      hits.push_back(hit);
      return media_.crossing(hit.id) == Media::Crossing::opaque;
    });
    if (blocked) return {};
    std::ranges::sort(hits, [](const Hit<T>& a, const Hit<T>& b) { return a.before(b); });
    size_t next = 0;
    const auto next_hit = [&](const Hit<T>& last, T t_max) -> std::optional<Hit<T>> {
      while (next < hits.size() && !last.before(hits[next])) ++next;
      if (next == hits.size() || hits[next].t > t_max) return std::nullopt;
      return hits[next];
    };
    const InterfaceFinder<Core> finder(sample.core, media_);
    Vec3<T> share(1, 1, 1);
    Hit<T> last = Hit<T>::start();
    while (const auto found = finder.next_among(ray, inside, last, next_hit)) {
      const Surfacing<T>& passed = surfacing(sample.core, found->hit.id);
      share = share * passed.filter * passed.refract * also_passed(sample.core, *found);
      inside = found->beyond;
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
    T share = bent ? 0 : 1;
    if (bent && material.fresnel) share = fresnel(n1, n2, bent->cos_incident, bent->cos_transmitted);
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
