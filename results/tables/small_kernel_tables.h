// The tables of kernels other than intersection: pure functions of what was recorded.
#pragma once

#include <vector>

#include "results/kernel_results.h"
#include "results/tables/accuracy_tables.h"
#include "results/tables/table.h"

namespace raysweep {

/// Of each kernel nanoseconds an operation, and how many times the quickest of the row: columns are the
/// values of the factor that has most names, rows those of its other factors. None of intersection.
[[nodiscard]] std::vector<NamedTable> operation_tables(const KernelResults& results);

/// Of each kernel whose operations were timed one by one, `<kernel>-ticks`: the least, the mean, the most and
/// the sum of a record, medians over rounds.
[[nodiscard]] std::vector<NamedTable> tick_tables(const KernelResults& results);

/// For programs: one row a cell, every number unrounded.
[[nodiscard]] Table small_kernel_data(const KernelResults& results);

}  // namespace raysweep
