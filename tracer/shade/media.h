// The media of a scene: which primitives bound them, and which one is where.
#pragma once

#include <vector>

#include "tracer/scene/scene.h"
#include "tracer/shade/medium_set.h"

namespace raysweep {

/// Media are ranked by their material's `priority`; of equal ones that of the smaller object (by its box) is
/// higher, so that what is put into something else is there without being told.
class Media {
 public:
  /// What crossing a primitive does.
  enum class Crossing : unsigned char {
    opaque,   // nothing crosses
    sheet,    // passes, and divides no media
    along,    // enters a medium when the ray runs along the primitive's own normal, else leaves it
    against,  // enters it when the ray runs against the normal
  };

  explicit Media(const Scene& scene);

  [[nodiscard]] Crossing crossing(uint32_t primitive) const { return crossings_[primitive]; }
  /// Of the medium or sheet that the primitive is part of.
  [[nodiscard]] uint32_t rank(uint32_t primitive) const { return ranks_[primitive]; }

  /// Refractive index of the medium that is there; 1 outside.
  [[nodiscard]] double ior(const MediumSet& set) const { return set.empty() ? 1 : ior_[set.top()]; }

  /// The media around the camera.
  [[nodiscard]] const MediumSet& at_camera() const { return at_camera_; }

  /// Whether a ray that meets nothing more may be in these media: only half-spaces reach that far.
  [[nodiscard]] bool may_end_in(const MediumSet& set) const {
    return std::ranges::all_of(set, [&](uint32_t rank) { return unbounded_[rank] != 0; });
  }

 private:
  std::vector<Crossing> crossings_;       // of each primitive
  std::vector<uint32_t> ranks_;           // of each primitive; those of sheets follow those of media
  std::vector<double> ior_;               // by rank
  std::vector<unsigned char> unbounded_;  // by rank
  MediumSet at_camera_;
};

}  // namespace raysweep
