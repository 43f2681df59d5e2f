#include "tracer/accel/m11.h"
#include "tracer/renderers.h"

namespace raysweep {

std::unique_ptr<const Renderer> make_m11_renderer(const Scene& scene, const RenderSettings& settings) {
  return pick_renderer<M11Core>(scene, settings);
}

}  // namespace raysweep
