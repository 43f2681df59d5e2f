// Opaque scenes in stages: the rays of many samples at once are generated, traced, shaded, their shadow rays
// traced, and the reflected ones go round again. The same arithmetic in the same order for each sample as
// MirrorPaths, hence the same colours, bit for bit.
#pragma once

#include "tracer/paths/path_end.h"
#include "tracer/render.h"
#include "tracer/sample/pattern.h"
#include "tracer/sample/sample_walk.h"
#include "tracer/scene/view.h"
#include "tracer/shade/lighting.h"
#include "tracer/wide/hit_points.h"
#include "tracer/wide/kernels.h"

namespace raysweep {

/// `Core` traces batches: `closest(rays, hits, scratch)`, `occluded(rays, hits, scratch)`, with
/// `primitives()` that know the surface at a hit, and `closest(ray)`. A scratch with `begin_level` is told
/// when rays are the camera's, level 1, or mirrored ones.
template <class Core, class Scratch = KernelScratch>
class Staged final : public Renderer {
 public:
  /// `more` goes to the core.
  template <class... More>
  Staged(const Scene& scene, const RenderSettings& settings, const More&... more)
      : core_(scene, settings.accel, settings.leaf, more...),
        lighting_(scene),
        end_(scene, settings),
        background_(scene.background),
        view_(scene.camera, settings.width, settings.height) {
    for (const Subpixel& s : make_pattern(settings.pattern, settings.subpixels))
      pattern_.push_back({static_cast<float>(s.x), static_cast<float>(s.y)});
  }

  using Renderer::render;

  [[nodiscard]] std::unique_ptr<Workspace> make_workspace() const override {
    return std::make_unique<Work>(samples_at_once(), lighting_.lights().size());
  }

  RenderCounts render(const Tile& tile, Film& film, Workspace& workspace) const override {
    const size_t pixel_count = static_cast<size_t>(tile.width) * static_cast<size_t>(tile.height);
    const size_t sample_count = pixel_count * pattern_.size();
    const size_t at_once = samples_at_once();
    Work& work = static_cast<Work&>(workspace);
    RenderCounts counts;
    counts.rays.primary = sample_count;
    SampleWalk generated(tile, pattern_.size()), gathered = generated;
    Vec3d pixel;  // in double: of many thousand samples a float's sum drifts
    for (size_t first = 0; first < sample_count; first += at_once) {
      const size_t count = std::min(at_once, sample_count - first);
      generate(work, count, generated);
      trace(work, counts);
      gather(work, count, gathered, pixel, film);
    }
    return counts;
  }

  [[nodiscard]] uint32_t first_hit(int x, int y) const override {
    const auto hit = core_.closest(view_.through(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f));
    return hit ? hit->id : no_hit_id;
  }

  /// What the core keeps in a workspace of such a renderer's making.
  [[nodiscard]] static const Scratch& scratch_of(const Workspace& workspace) {
    return static_cast<const Work&>(workspace).scratch;
  }

 private:
  /// Samples whose rays are handed on together: enough to keep a kernel's rays in flight busy, few enough for
  /// the second cache, also where each of them sends rays to many lights.
  [[nodiscard]] size_t samples_at_once() const {
    constexpr size_t least = 64, most = 1024, shadow_rays = 4096;
    return std::clamp(shadow_rays / std::max<size_t>(lighting_.lights().size(), 1), least, most);
  }

  struct Offset {
    float x, y;
  };

  struct Path {
    uint32_t sample;
    float weight;
  };

  /// A light that a hit may see.
  struct Pending {
    uint32_t hit, light;
    float cosine, highlight;
  };

  /// What the stages hand on, for the samples of one round.
  struct Work final : Workspace {
    Work(size_t samples, size_t lights)
        : rays(samples),
          hits(samples),
          points(samples),
          lit(samples),
          shadow_rays(samples * lights),
          shadow_hits(samples * lights),
          colours(samples),
          light(samples),
          paths(samples) {
      std::ranges::fill(rays.t_max, std::numeric_limits<float>::infinity());
      pending.reserve(samples * lights);
    }

    RayBatch rays;  // of `paths`
    HitBatch hits;
    HitPoints points;
    Lit lit;
    RayBatch shadow_rays;  // of `pending`
    HitBatch shadow_hits;
    std::vector<Vec3f> colours;  // of samples
    std::vector<Vec3f> light;    // that hits send back
    std::vector<Path> paths;
    std::vector<Pending> pending;
    Scratch scratch;
  };

  /// Generates the camera's rays of the next `count` samples.
  void generate(Work& work, size_t count, SampleWalk& walk) const {
    RayBatch& rays = work.rays;
    rays.size = count;
    float *const x = rays.direction_x.data(), *const y = rays.direction_y.data(),
                 *const z = rays.direction_z.data();
    for (size_t i = 0; i < count; ++i) {
      const Offset& offset = pattern_[walk.subpixel];
      x[i] = static_cast<float>(walk.x) + offset.x;
      y[i] = static_cast<float>(walk.y) + offset.y;
      walk.next();
    }
    // Points become directions in a loop of nothing else and with a view that no store can change: compilers
    // turn it into vectors.
    const View<float> view = view_;
    for (size_t i = 0; i < count; ++i) {
      const Vec3f direction = view.towards(x[i], y[i]);
      x[i] = direction.x;
      y[i] = direction.y;
      z[i] = direction.z;
    }
    std::fill_n(rays.origin_x.begin(), count, view.position().x);
    std::fill_n(rays.origin_y.begin(), count, view.position().y);
    std::fill_n(rays.origin_z.begin(), count, view.position().z);
    std::fill_n(work.colours.begin(), count, Vec3f());
    for (size_t i = 0; i < count; ++i) work.paths[i] = {static_cast<uint32_t>(i), 1};
  }

  /// Adds the colours of `count` samples up to those of pixels; `pixel` is the one begun.
  void gather(const Work& work, size_t count, SampleWalk& walk, Vec3d& pixel, Film& film) const {
    const double share = 1.0 / static_cast<double>(pattern_.size());
    for (size_t i = 0; i < count; ++i) {
      pixel += Vec3d(work.colours[i]);
      const int x = walk.x, y = walk.y;
      if (!walk.next()) continue;
      film.at(x, y) = Vec3f(pixel * share);
      pixel = {};
    }
  }

  /// Follows the generated rays from mirror to mirror and leaves what they bring back in `colours`.
  void trace(Work& work, RenderCounts& counts) const {
    for (int level = 1; work.rays.size > 0; ++level) {
      if constexpr (requires(Scratch scratch) { scratch.begin_level(level); })
        work.scratch.begin_level(level);
      core_.closest(work.rays, work.hits, work.scratch);
      find_surfaces(work);
      mirror(work.rays, work.points);
      ask_lights(work, counts.rays);
      core_.occluded(work.shadow_rays, work.shadow_hits, work.scratch);
      add_light(work);
      go_on(work, level, counts);
    }
  }

  /// Rays that hit nothing end; the others move to the front, each with its surface's point in place of its
  /// origin. No later one has been read by then, and none is written over.
  void find_surfaces(Work& work) const {
    size_t count = 0;
    for (size_t i = 0; i < work.rays.size; ++i) {
      const Path path = work.paths[i];
      const uint32_t id = work.hits.id[i];
      if (id == no_hit_id) {
        work.colours[path.sample] += background_ * path.weight;
        continue;
      }
      const Ray<float> ray = work.rays.ray(i);
      const Surface<float> surface = core_.primitives().surface(ray, {work.hits.t[i], id});
      const Surfacing<float>& material = lighting_.material(core_.primitives().material(id));
      work.rays.set(count, {surface.point, ray.direction});
      work.points.normal.set(count, surface.normal);
      work.points.clearance[count] = surface.clearance;
      work.points.material[count] = &material;
      work.light[count] = material.ambient;
      work.paths[count++] = path;
    }
    work.rays.size = count;
  }

  /// Sends a ray from each hit to each light in front of it: to one light after the other, so that
  /// neighbouring rays run side by side.
  void ask_lights(Work& work, RayCounts& counts) const {
    work.pending.clear();
    work.shadow_rays.size = 0;
    for (uint32_t light = 0; light < lighting_.lights().size(); ++light) {
      const Lit& lit = work.lit;
      look_at_light(work.rays, work.points, lighting_.lights()[light].position, work.lit);
      for (uint32_t i = 0; i < work.rays.size; ++i) {
        // As in Lighting::for_each_light.
        if (!(work.points.material[i]->answers_light && lit.cosine[i] > 0 && lit.distance[i] > 0)) continue;
        const Ray<float> ray{work.rays.ray(i).origin, lit.to_light[i]};
        work.shadow_rays.set(work.shadow_rays.size++, ray, lit.distance[i]);
        work.pending.push_back({i, light, lit.cosine[i], lit.highlight[i]});
      }
    }
    counts.shadow += work.pending.size();
  }

  /// Adds the lights that hits do see, each hit's in the lights' order.
  void add_light(Work& work) const {
    for (size_t i = 0; i < work.pending.size(); ++i) {
      if (work.shadow_hits.id[i] != no_hit_id) continue;
      const Pending& seen = work.pending[i];
      work.light[seen.hit] += lighting_.lights()[seen.light].intensity *
                              phong(*work.points.material[seen.hit], seen.cosine, seen.highlight);
    }
    for (size_t i = 0; i < work.rays.size; ++i)
      work.colours[work.paths[i].sample] += work.paths[i].weight * work.light[i];
  }

  /// Leaves the mirrored rays of those paths that go on.
  void go_on(Work& work, int level, RenderCounts& counts) const {
    size_t count = 0;
    for (size_t i = 0; i < work.rays.size; ++i) {
      Path path = work.paths[i];
      if (end_.is_here(*work.points.material[i], level, path.weight, counts.left_out)) continue;
      work.paths[count] = path;
      work.rays.set(count++, {work.rays.ray(i).origin, work.points.mirrored[i]});
    }
    counts.rays.reflected += count;
    work.rays.size = count;
  }

  Core core_;
  Lighting<float> lighting_;
  PathEnd<float> end_;
  Vec3f background_;
  View<float> view_;
  std::vector<Offset> pattern_;
};

}  // namespace raysweep
