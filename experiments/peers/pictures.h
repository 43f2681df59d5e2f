// Our tracer against itself with Embree as its core, on whole pictures.
#pragma once

#include <array>

#include "experiments/peers/embree_team.h"
#include "experiments/peers/picture_maker.h"
#include "results/statistics/statistics.h"

namespace raysweep {

struct PicturesRequest {
  std::vector<std::string> modes;  // names of modes(); none: no pictures
  double scale = 0.5;              // of the modes' width and height
  int rounds = 7;                  // in each of which both make a picture; fewer than six have no interval
  double run_seconds = 0.02;       // quicker pictures are made again until they have taken about as long
  uint64_t seed = 1;               // of the order in each round
};

/// Both are measured with one thread and with two.
inline constexpr std::array picture_threads{1, 2};

struct PictureRow {
  std::string scene, mode;
  size_t triangles = 0;
  int width = 0, height = 0, threads = 1;
  std::string ours, embree;                           // the instruction set, and Embree's way
  double ours_per_second = 0, embree_per_second = 0;  // pictures, medians over the rounds
  Estimate ratio;                                     // ours / Embree's, median of the rounds' ratios
  double embree_share = 0;                            // of its threads' time inside Embree's calls
  PixelDifferences differences;
};

/// Throws RequestError where there is no such mode.
[[nodiscard]] const Mode& picture_mode(const std::string& name);

/// What pictures of `mode` are made with: `scale` of its width and height, by the core "wide".
[[nodiscard]] RenderSettings picture_settings(const Mode& mode, double scale);

/// With `lights` lights; a scene file has no more than it holds. Throws SceneError.
[[nodiscard]] Scene lit_scene(const std::string& name, int lights);

/// The rows of one scene, whose triangles `embree` has, in one mode.
[[nodiscard]] std::vector<PictureRow> compare_pictures(const std::string& scene, const std::string& mode,
                                                       const PicturesRequest& request,
                                                       const EmbreePictures& embree);

}  // namespace raysweep
