// Backward ray tracing (Whitted 1980) over any core and any kind of paths.
#pragma once

#include "tracer/render.h"
#include "tracer/sample/pattern.h"
#include "tracer/scene/view.h"

namespace raysweep {

/// `Paths::trace(core, ray, counts, scratch)` gives the colour that a camera's ray brings back.
template <class Core, class Paths>
class Whitted final : public Renderer {
 public:
  using T = typename Core::Real;

  /// `more` goes to the core.
  template <class... More>
  Whitted(const Scene& scene, const RenderSettings& settings, const More&... more)
      : core_(scene, settings.accel, settings.leaf, more...),
        paths_(scene, settings),
        view_(scene.camera, settings.width, settings.height) {
    for (const Subpixel& s : make_pattern(settings.pattern, settings.subpixels)) {
      pattern_.push_back({static_cast<T>(s.x), static_cast<T>(s.y)});
    }
  }

  using Renderer::render;

  [[nodiscard]] std::unique_ptr<Workspace> make_workspace() const override {
    return std::make_unique<PathSpace>();
  }

  RenderCounts render(const Tile& tile, Film& film, Workspace& workspace) const override {
    RenderCounts counts;
    typename Paths::Scratch& scratch = static_cast<PathSpace&>(workspace).scratch;
    for (int y = tile.y; y < tile.y + tile.height; ++y) {
      for (int x = tile.x; x < tile.x + tile.width; ++x) film.at(x, y) = pixel(x, y, counts, scratch);
    }
    return counts;
  }

  [[nodiscard]] uint32_t first_hit(int x, int y) const override {
    const auto hit = core_.closest(view_.through(static_cast<T>(x) + T(0.5), static_cast<T>(y) + T(0.5)));
    return hit ? hit->id : no_hit_id;
  }

 private:
  struct Offset {
    T x, y;
  };

  struct PathSpace final : Workspace {
    typename Paths::Scratch scratch;
  };

  Vec3f pixel(int x, int y, RenderCounts& counts, typename Paths::Scratch& scratch) const {
    // In double: of many thousand samples a float's sum drifts.
    Vec3d sum;
    for (const Offset& o : pattern_) {
      const Ray<T> ray = view_.through(static_cast<T>(x) + o.x, static_cast<T>(y) + o.y);
      sum += Vec3d(paths_.trace(core_, ray, counts, scratch));
    }
    counts.rays.primary += pattern_.size();
    return Vec3f(sum * (1.0 / static_cast<double>(pattern_.size())));
  }

  Core core_;
  Paths paths_;
  View<T> view_;
  std::vector<Offset> pattern_;
};

}  // namespace raysweep
