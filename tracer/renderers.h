// One factory per core, each in its own translation unit, so that cores compile side by side.
#pragma once

#include "tracer/intersect/all.h"
#include "tracer/paths/glass_paths.h"
#include "tracer/paths/mirror_paths.h"
#include "tracer/render.h"
#include "tracer/whitted.h"

namespace raysweep {

/// Null where precision or method is unknown.
[[nodiscard]] std::unique_ptr<const Renderer> make_scalar_renderer(const Scene& scene,
                                                                   const RenderSettings& settings);
[[nodiscard]] std::unique_ptr<const Renderer> make_m11_renderer(const Scene& scene,
                                                                const RenderSettings& settings);
/// Throws std::invalid_argument if the instruction set does not run here.
[[nodiscard]] std::unique_ptr<const Renderer> make_wide_renderer(const Scene& scene,
                                                                 const RenderSettings& settings);

/// Scenes in which nothing refracts take the paths that know nothing of it.
template <class Core>
[[nodiscard]] std::unique_ptr<const Renderer> make_whitted(const Scene& scene,
                                                           const RenderSettings& settings) {
  if (has_transparency(scene)) return std::make_unique<Whitted<Core, GlassPaths<Core>>>(scene, settings);
  return std::make_unique<Whitted<Core, MirrorPaths<Core>>>(scene, settings);
}

/// The renderer of `Core<precision, method>` that the settings name, or null.
template <template <class, class> class Core>
[[nodiscard]] std::unique_ptr<const Renderer> pick_renderer(const Scene& scene,
                                                            const RenderSettings& settings) {
  std::unique_ptr<const Renderer> renderer;
  for_each_method([&](auto method) {
    using Method = decltype(method);
    if (settings.method != Method::name) return;
    if (settings.precision == "float") renderer = make_whitted<Core<float, Method>>(scene, settings);
    if (settings.precision == "double") renderer = make_whitted<Core<double, Method>>(scene, settings);
  });
  return renderer;
}

}  // namespace raysweep
