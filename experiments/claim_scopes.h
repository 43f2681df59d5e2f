// What claims about an experiment of each kind can name, by its sweep.
#pragma once

#include "experiments/accuracy_config.h"
#include "experiments/config.h"
#include "experiments/kernel_config.h"
#include "experiments/pixels_config.h"

namespace raysweep {

[[nodiscard]] ClaimScope claim_scope(const Config& config);
[[nodiscard]] ClaimScope claim_scope(const KernelConfig& config);
[[nodiscard]] ClaimScope claim_scope(const AccuracyConfig& config);
[[nodiscard]] ClaimScope claim_scope(const PixelsConfig& config);

}  // namespace raysweep
