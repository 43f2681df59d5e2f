// The tables of a kernel experiment: pure functions of what was recorded.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "results/kernel_results.h"
#include "results/tables/accuracy_tables.h"
#include "results/tables/table.h"

namespace raysweep {

/// Base kernels, methods × lists of tests: nanoseconds a test, and how many times the best method's;
/// `speed-float` and of double. Lists that differ by their hit rate alone stand in `hit_rate_tables`.
[[nodiscard]] std::vector<NamedTable> speed_tables(const KernelResults& results);

/// Base kernels, methods × hit rates: nanoseconds a test; `hit-rates-float` and of double. None where no
/// protocol was run with several.
[[nodiscard]] std::vector<NamedTable> hit_rate_tables(const KernelResults& results);

/// What each factor changes, methods and changes × lists of tests: times the base kernel's time, by rounds;
/// `factors-float` and of double. None where base kernels alone were run.
[[nodiscard]] std::vector<NamedTable> factor_tables(const KernelResults& results);

/// Cells with records that are not valid, and why; none without.
[[nodiscard]] std::optional<Table> void_table(const KernelResults& results);

/// For programs: one row a cell, every number unrounded.
[[nodiscard]] Table kernel_data(const KernelResults& results);

/// What a terminal should show.
[[nodiscard]] std::string kernel_tables_as_text(const KernelData& data);

/// Writes all of them, as .md, .tex (LaTeX with booktabs) and .csv, and `cells.csv`, into `folder`, which is
/// made. Those that people read.
std::vector<NamedTable> write_kernel_tables(const KernelData& data, const std::filesystem::path& folder);

}  // namespace raysweep
