// The number that a group's values come to, with what is unsure of it.
#pragma once

#include <optional>

#include "results/claims/group_question.h"

namespace raysweep {

/// The statistic of the medians. Its interval: of measured values by drawing whole rounds with replacement,
/// the same ones for all (none for fewer than 6 rounds); of printed ones the sum of what half a unit of each
/// last digit changes; of exact ones the value alone.
[[nodiscard]] Estimate estimate(const GroupQuestion& question);

}  // namespace raysweep
