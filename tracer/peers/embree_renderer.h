// Whole pictures with Embree as the core: everything but the tracing of triangles is the fast core's code.
#pragma once

#include "tracer/peers/embree_core.h"
#include "tracer/render.h"

namespace raysweep {

/// `scene` must be that of `geometry`, its lights excepted, and opaque; else std::invalid_argument is thrown.
[[nodiscard]] std::unique_ptr<const Renderer> make_embree_renderer(const Scene& scene,
                                                                   const RenderSettings& settings,
                                                                   const EmbreeGeometry& geometry);

/// How long Embree's calls have taken all tiles that `workspace`, of such a renderer's making, was used for.
[[nodiscard]] double seconds_in_embree(const Workspace& workspace);

}  // namespace raysweep
