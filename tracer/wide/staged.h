// Opaque scenes in stages: the rays of many samples at once are generated, traced, shaded, their shadow rays
// traced, and the reflected ones go round again. The same arithmetic in the same order for each sample as
// MirrorPaths, hence the same colours, bit for bit.
#pragma once

#include "tracer/paths/path_end.h"
#include "tracer/render.h"
#include "tracer/sample/pattern.h"
#include "tracer/scene/view.h"
#include "tracer/shade/lighting.h"
#include "tracer/wide/kernels.h"

namespace raysweep {

/// `Core` traces batches: `closest(rays, hits, scratch)`, `occluded(rays, hits, scratch)`, with
/// `primitives()` that know the surface at a hit, and `closest(ray)`.
template <class Core>
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
    return std::make_unique<Work>(samples_at_once(), lighting_.light_count());
  }

  RenderCounts render(const Tile& tile, Film& film, Workspace& workspace) const override {
    const size_t pixel_count = static_cast<size_t>(tile.width) * static_cast<size_t>(tile.height);
    const size_t sample_count = pixel_count * pattern_.size();
    const size_t at_once = samples_at_once();
    Work& work = static_cast<Work&>(workspace);
    RenderCounts counts;
    counts.rays.primary = sample_count;
    Vec3d pixel;  // in double: of many thousand samples a float's sum drifts
    for (size_t first = 0; first < sample_count; first += at_once) {
      const size_t count = std::min(at_once, sample_count - first);
      generate(work, first, count, tile);
      trace(work, counts);
      for (size_t i = 0; i < count; ++i) {
        pixel += Vec3d(work.colours[i]);
        if ((first + i + 1) % pattern_.size() != 0) continue;
        const auto [x, y] = place((first + i) / pattern_.size(), tile);
        film.at(x, y) = Vec3f(pixel * (1.0 / static_cast<double>(pattern_.size())));
        pixel = {};
      }
    }
    return counts;
  }

  [[nodiscard]] uint32_t first_hit(int x, int y) const override {
    const auto hit = core_.closest(view_.through(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f));
    return hit ? hit->id : no_hit_id;
  }

 private:
  /// Samples whose rays are handed on together: enough to keep a kernel's rays in flight busy, few enough for
  /// the second cache, also where each of them sends rays to many lights.
  [[nodiscard]] size_t samples_at_once() const {
    constexpr size_t least = 64, most = 1024, shadow_rays = 4096;
    return std::clamp(shadow_rays / std::max<size_t>(lighting_.light_count(), 1), least, most);
  }

  struct Offset {
    float x, y;
  };
  struct Place {
    int x, y;
  };

  struct Path {
    uint32_t sample;
    float weight;
  };

  /// A path's hit with the light that it gathers.
  struct Shaded {
    Path path;
    Vec3f light;
  };

  /// What a light adds to a shaded hit if nothing is in its way.
  struct Pending {
    uint32_t shaded;
    Vec3f light;
  };

  /// What the stages hand on, for the samples of one round.
  struct Work final : Workspace {
    Work(size_t samples, size_t lights)
        : rays(samples),
          hits(samples),
          shadow_rays(samples * lights),
          shadow_hits(samples * lights),
          colours(samples),
          paths(samples) {
      shaded.reserve(samples);
      pending.reserve(samples * lights);
    }

    RayBatch rays;  // of `paths`
    HitBatch hits;
    RayBatch shadow_rays;  // of `pending`
    HitBatch shadow_hits;
    std::vector<Vec3f> colours;  // of samples
    std::vector<Path> paths;
    std::vector<Shaded> shaded;
    std::vector<Pending> pending;
    KernelScratch scratch;
  };

  [[nodiscard]] static Place place(size_t pixel, const Tile& tile) {
    const auto width = static_cast<size_t>(tile.width);
    return {tile.x + static_cast<int>(pixel % width), tile.y + static_cast<int>(pixel / width)};
  }

  /// Generates the camera's rays of `count` samples, the tile's `first` and following.
  void generate(Work& work, size_t first, size_t count, const Tile& tile) const {
    size_t subpixel = first % pattern_.size(), pixel = first / pattern_.size();
    for (size_t i = 0; i < count; ++i) {
      const Offset& offset = pattern_[subpixel];
      const auto [x, y] = place(pixel, tile);
      work.rays.set(i, view_.through(static_cast<float>(x) + offset.x, static_cast<float>(y) + offset.y));
      work.paths[i] = {static_cast<uint32_t>(i), 1};
      work.colours[i] = {};
      if (++subpixel == pattern_.size()) {
        subpixel = 0;
        pixel++;
      }
    }
    work.rays.size = count;
  }

  /// Follows the generated rays from mirror to mirror and leaves what they bring back in `colours`.
  void trace(Work& work, RenderCounts& counts) const {
    for (int level = 1; work.rays.size > 0; ++level) {
      core_.closest(work.rays, work.hits, work.scratch);
      shade(work, level, counts);
      core_.occluded(work.shadow_rays, work.shadow_hits, work.scratch);
      for (size_t i = 0; i < work.pending.size(); ++i) {
        if (work.shadow_hits.id[i] == no_hit_id)
          work.shaded[work.pending[i].shaded].light += work.pending[i].light;
      }
      for (const Shaded& s : work.shaded) work.colours[s.path.sample] += s.path.weight * s.light;
    }
  }

  /// Turns hits into shadow rays and the next level's rays.
  void shade(Work& work, int level, RenderCounts& counts) const {
    work.shaded.clear();
    work.pending.clear();
    work.shadow_rays.size = 0;
    size_t next = 0;
    for (size_t i = 0; i < work.rays.size; ++i) {
      Path path = work.paths[i];
      if (work.hits.id[i] == no_hit_id) {
        work.colours[path.sample] += background_ * path.weight;
        continue;
      }
      const Ray<float> mirrored = shade_hit(work, i, counts.rays);
      const uint32_t material = core_.primitives().material(work.hits.id[i]);
      if (end_.is_here(lighting_.material(material), level, path.weight, counts.left_out)) continue;
      // Rays are replaced from the front: no later one has been read yet, and none is written over.
      work.paths[next] = path;
      work.rays.set(next++, mirrored);
      counts.rays.reflected++;
    }
    work.rays.size = next;
  }

  /// Sends rays to the lights from the hit of ray `i`; the mirrored ray.
  Ray<float> shade_hit(Work& work, size_t i, RayCounts& counts) const {
    const Ray<float> ray = work.rays.ray(i);
    const uint32_t id = work.hits.id[i];
    const Surface<float> surface = core_.primitives().surface(ray, {work.hits.t[i], id});
    const Surfacing<float>& material = lighting_.material(core_.primitives().material(id));
    const Ray<float> mirrored =
        spawn(surface, normalize(reflect(ray.direction, surface.normal)), true, surface.clearance);
    const auto index = static_cast<uint32_t>(work.shaded.size());
    work.shaded.push_back({work.paths[i], material.ambient});
    lighting_.for_each_light(material, mirrored.origin, surface.normal, counts, [&](const auto& to_light) {
      work.shadow_rays.set(work.shadow_rays.size++, to_light.ray, to_light.distance);
      work.pending.push_back({index, to_light.intensity * Lighting<float>::light(material, surface.normal,
                                                                                 to_light, ray.direction)});
    });
    return mirrored;
  }

  Core core_;
  Lighting<float> lighting_;
  PathEnd<float> end_;
  Vec3f background_;
  View<float> view_;
  std::vector<Offset> pattern_;
};

}  // namespace raysweep
