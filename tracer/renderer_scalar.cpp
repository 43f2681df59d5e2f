#include "tracer/accel/scalar.h"
#include "tracer/renderers.h"

namespace raysweep {

std::unique_ptr<const Renderer> make_scalar_renderer(const Scene& scene, const RenderSettings& settings) {
  return pick_renderer<ScalarCore>(scene, settings);
}

}  // namespace raysweep
