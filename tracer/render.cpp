#include "tracer/render.h"

#include <stdexcept>
#include <string>

#include "tracer/renderers.h"

namespace raysweep {

std::unique_ptr<const Renderer> make_renderer(const Scene& scene, const RenderSettings& settings) {
  for (const Material& material : scene.materials) {
    if (const std::string problem = problem_of(material); !problem.empty())
      throw std::invalid_argument("scene \"" + scene.name + "\": a material's " + problem);
  }
  std::unique_ptr<const Renderer> renderer;
  if (settings.core == "scalar") renderer = make_scalar_renderer(scene, settings);
  if (settings.core == "m11") renderer = make_m11_renderer(scene, settings);
  if (settings.core == "wide") renderer = make_wide_renderer(scene, settings);
  if (!renderer) {
    throw std::invalid_argument("no renderer for core \"" + settings.core + "\", precision \"" +
                                settings.precision + "\", method \"" + settings.method + "\"");
  }
  return renderer;
}

}  // namespace raysweep
