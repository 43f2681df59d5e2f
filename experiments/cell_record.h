// A cell in the words of a record.
#pragma once

#include "experiments/cell.h"
#include "results/record.h"

namespace raysweep {

/// A record with the factors of `cell` and nothing measured.
[[nodiscard]] Record record_of(const Cell& cell);

}  // namespace raysweep
