#include "tracer/peers/embree_renderer.h"

#include "tracer/wide/staged.h"

namespace raysweep {

namespace {

using EmbreeStaged = Staged<EmbreeCore, EmbreeScratch>;

}  // namespace

std::unique_ptr<const Renderer> make_embree_renderer(const Scene& scene, const RenderSettings& settings,
                                                     const EmbreeGeometry& geometry) {
  if (has_transparency(scene))
    throw std::invalid_argument("pictures by Embree are of opaque scenes; \"" + scene.name +
                                "\" holds glass");
  return std::make_unique<EmbreeStaged>(scene, settings, geometry);
}

double seconds_in_embree(const Workspace& workspace) {
  return EmbreeStaged::scratch_of(workspace).seconds_inside;
}

}  // namespace raysweep
