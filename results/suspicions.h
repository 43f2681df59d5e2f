// Numbers too good to be taken at their word.
#pragma once

#include <string>
#include <vector>

#include "results/noise_floor.h"
#include "results/scaling.h"

namespace raysweep {

/// Above this a speedup per processor is suspicious: 5 % is more than turbo's steps and intervals explain.
inline constexpr double suspicious_efficiency = 1.05;

/// Sentences about a row that is faster than it can be by its threads, interval and all: superlinear, where
/// the low end of the speedup exceeds the processors that the threads fill by more than 5 % (processors, not
/// cores: the second hardware thread of a core is worth something), and one thread faster than the serial
/// scheduler by more than the noise floor.
[[nodiscard]] std::vector<std::string> suspicions(const CellRow& row, const NoiseFloor& floor);

}  // namespace raysweep
