// Embree as contestants. It comes as a module, loaded on demand: with it comes TBB, and a process that
// measures schedulers holds no runtime that it does not measure.
#pragma once

#include "experiments/peers/contestant.h"
#include "tracer/render.h"

namespace raysweep {

/// Pictures of one opaque scene, its triangles in Embree's hands.
class EmbreePictures {
 public:
  virtual ~EmbreePictures() = default;
  /// Names of the ways to hand rays to Embree.
  [[nodiscard]] virtual std::vector<std::string> ways() const = 0;
  /// `scene` may have other lights than the one that all was made of. Renderers must not outlive this.
  [[nodiscard]] virtual std::unique_ptr<const Renderer> make_renderer(const Scene& scene,
                                                                      const RenderSettings& settings,
                                                                      size_t way) const = 0;
  /// What Embree's calls have taken the user of `workspace`, one of such a renderer, so far.
  [[nodiscard]] virtual double seconds_inside(const Workspace& workspace) const = 0;
};

/// What the module offers.
struct EmbreeModule {
  size_t layout = 0;  // embree_layout
  std::string version;
  bool has_assertions = false;  // checks in its inner loops, which cost time; Debian's packages have them
  /// Every instruction set of this processor, both qualities, packets of every width, told to be coherent and
  /// incoherent; with `robust` those again, robust.
  Team (*make_team)(const Scene& scene, bool robust) = nullptr;
  std::unique_ptr<EmbreePictures> (*make_pictures)(const Scene& scene) = nullptr;
  ShareWork share_by_tbb = nullptr;  // as Embree shares its builds
};

/// Differs between programs and modules that were built of different sources and would misread each other.
inline constexpr size_t embree_layout =
    ((((sizeof(Scene) * 1021 + sizeof(Team)) * 1021 + sizeof(RayBatch)) * 1021 + sizeof(HitBatch)) * 1021 +
     sizeof(RenderSettings)) *
        1021 +
    sizeof(EmbreeModule) + sizeof(Film);

/// The symbol that is looked up.
using EmbreeModuleFunction = const EmbreeModule* (*)();
inline constexpr const char* embree_module_symbol = "raysweep_embree_module";

/// Throws RequestError, with what to do, where the module is missing.
[[nodiscard]] const EmbreeModule& load_embree();

}  // namespace raysweep
