#include "tracer/renderers.h"
#include "tracer/wide/staged.h"
#include "tracer/wide/wide_core.h"

namespace raysweep {

namespace {

template <class Core>
std::unique_ptr<const Renderer> make_with(const Scene& scene, const RenderSettings& settings,
                                          std::string_view isa) {
  if (has_transparency(scene)) return std::make_unique<Whitted<Core, GlassPaths<Core>>>(scene, settings, isa);
  return std::make_unique<Staged<Core>>(scene, settings, isa);
}

}  // namespace

std::unique_ptr<const Renderer> make_wide_renderer(const Scene& scene, const RenderSettings& settings) {
  if (settings.precision != "float") return nullptr;
  const std::string_view isa = settings.isa == "best" ? best_isa() : std::string_view(settings.isa);
  if (!runs_here(isa))
    throw std::invalid_argument("instruction set \"" + settings.isa + "\" does not run here");
  const auto found = std::ranges::find_if(built_isas(), [&](const Isa& i) { return i.name == isa; });
  std::unique_ptr<const Renderer> renderer;
  for_each_method([&](auto method) {
    using Method = decltype(method);
    if (settings.method != Method::name) return;
    if (found->width == 8) renderer = make_with<WideCore<Method, 8>>(scene, settings, isa);
    if (found->width == 4) renderer = make_with<WideCore<Method, 4>>(scene, settings, isa);
  });
  return renderer;
}

}  // namespace raysweep
