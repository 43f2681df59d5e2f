// Embree as contestants. It comes as a module, loaded on demand: with it comes TBB, and a process that
// measures schedulers holds no runtime that it does not measure.
#pragma once

#include "experiments/peers/contestant.h"
#include "tracer/scene/scene.h"

namespace raysweep {

/// What the module offers.
struct EmbreeModule {
  size_t layout = 0;  // embree_layout
  std::string version;
  bool has_assertions = false;  // checks in its inner loops, which cost time; Debian's packages have them
  /// Every instruction set of this processor, both qualities, packets of every width, told to be coherent and
  /// incoherent; with `robust` those again, robust.
  Team (*make_team)(const Scene& scene, bool robust) = nullptr;
};

/// Differs between programs and modules that were built of different sources and would misread each other.
inline constexpr size_t embree_layout =
    ((sizeof(Scene) * 4096 + sizeof(Team)) * 4096 + sizeof(RayBatch)) * 4096 + sizeof(HitBatch);

/// The symbol that is looked up.
using EmbreeModuleFunction = const EmbreeModule* (*)();
inline constexpr const char* embree_module_symbol = "raysweep_embree_module";

/// Throws RequestError, with what to do, where the module is missing.
[[nodiscard]] const EmbreeModule& load_embree();

}  // namespace raysweep
