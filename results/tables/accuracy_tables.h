// The tables of an accuracy experiment: pure functions of what was recorded.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "results/accuracy_results.h"
#include "results/contract.h"
#include "results/tables/table.h"

namespace raysweep {

/// "45812", "16.7", or "≤ 300" where nothing failed (the bound of `zero_failures_bound`): failures per
/// million. "–" where there was nothing to fail.
[[nodiscard]] std::string per_million(const Failures& failures);

/// Failures of base variants, methods × cases, each case at its hardest difficulty that has something to
/// fail: `false-misses-float`, `false-hits-float`, `missed-rays-float`, and of double. None without any case.
[[nodiscard]] std::vector<NamedTable> failure_tables(const AccuracyResults& results);

/// The first difficulty at which a method fails, methods × cases: `where-failing-float` and of double.
[[nodiscard]] std::vector<NamedTable> where_failing_tables(const AccuracyResults& results);

/// How each method does as one case gets harder: `case-W1` and so on.
[[nodiscard]] std::vector<NamedTable> case_tables(const AccuracyResults& results);

/// What each change of one factor adds and takes, over all cases: one row a method, change and precision
/// that differ from the base variant anywhere; and every cell in which they do. None where base variants
/// alone were run.
[[nodiscard]] std::optional<Table> variant_table(const AccuracyResults& results);
[[nodiscard]] std::optional<Table> differing_cells_table(const AccuracyResults& results);

/// Variants that do not exist, and why; none if all that were asked for do.
[[nodiscard]] std::optional<Table> left_out_table(const std::vector<LeftOutVariant>& left_out);

/// For programs: one row a cell, every number unrounded.
[[nodiscard]] Table accuracy_data(const AccuracyResults& results);

/// What a terminal should show: where methods fail, and how often, and whether that is what they promise;
/// cases one by one stand in files.
[[nodiscard]] std::string accuracy_tables_as_text(const AccuracyData& data, const Contract& contract);

/// Writes all of them, as .md, .tex (LaTeX with booktabs) and .csv, and `cells.csv`, into `folder`, which is
/// made. Those that people read.
std::vector<NamedTable> write_accuracy_tables(const AccuracyData& data, const Contract& contract,
                                              const std::filesystem::path& folder);

}  // namespace raysweep
