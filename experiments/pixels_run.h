// Runs pixels experiments: from a config to records and pictures in a folder.
#pragma once

#include <memory>
#include <string>

#include "experiments/pixels_config.h"
#include "experiments/run_files.h"

namespace raysweep {

/// A pixels experiment that can be run: everything that can be refused has been.
struct PixelsExperiment {
  PixelsConfig config;
  std::unique_ptr<RunFiles> files;
};

/// Makes its folder, or takes it up. Throws RequestError as RunFiles.
[[nodiscard]] PixelsExperiment open_pixels(const PixelsConfig& config, const std::filesystem::path& folder,
                                           const Machine& machine, bool resume);

struct PixelsReport {
  size_t records = 0;       // that there are now, with those of an earlier run: one a cell and round
  size_t void_records = 0;  // among the new ones
  bool was_interrupted = false;
  std::string failure;  // empty, or why a scene cannot be rendered or something cannot be written
};

/// Runs the rounds that the folder lacks, picture by picture, all ways to make a picture in each round in an
/// order by lot; `quiet` keeps progress to itself. Ends after a round when the program is interrupted. All
/// renderers of a picture are in memory at once. The reference is the scalar core in doubles with the method
/// "woop_watertight". Into `pictures/` go the reference, and of each way with wrong pixels these in colour in
/// its picture and the map of FLIP.
[[nodiscard]] PixelsReport run_pixels(const PixelsExperiment& experiment, bool quiet);

}  // namespace raysweep
