// What claims about an experiment of each kind can name, by its sweep.
#pragma once

#include "experiments/accuracy_config.h"
#include "experiments/config.h"
#include "experiments/kernel_config.h"
#include "experiments/pixels_config.h"

namespace raysweep {

/// `is_whole`: the sweep is as the file has it.
[[nodiscard]] ClaimScope claim_scope(const Config& config, bool is_whole);
[[nodiscard]] ClaimScope claim_scope(const KernelConfig& config, bool is_whole);
[[nodiscard]] ClaimScope claim_scope(const AccuracyConfig& config, bool is_whole);
[[nodiscard]] ClaimScope claim_scope(const PixelsConfig& config, bool is_whole);

}  // namespace raysweep
