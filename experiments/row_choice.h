// One row of a run, named by some of its factors.
#pragma once

#include <string>
#include <vector>

#include "results/scaling.h"

namespace raysweep {

/// The row for which every condition of `text`, "scheduler=omp_static,threads=2", holds. Throws RequestError
/// for a factor that is not known, or where no row or several are meant: it names what would tell them apart.
[[nodiscard]] const CellRow& choose_row(const std::vector<CellRow>& rows, const std::string& text);

}  // namespace raysweep
