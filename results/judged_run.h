// What a run has to say, all in one: its claims judged, and report.json, which a page can be made of.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "results/claims/judge.h"
#include "results/claims/measured_cells.h"
#include "results/claims/published_rows.h"

namespace raysweep {

/// As machine.json or records have it; 0 and empty: unknown.
struct RunMachine {
  std::string host, cpu;
  MachineCounts counts;
};

struct JudgedRun {
  std::string experiment, title, kind;
  std::optional<double> noise_floor;  // a log ratio; none: unknown
  RunMachine machine;
  std::vector<MeasuredCell> cells;
  ClaimSheet sheet;
  std::vector<ClaimJudgement> claims;
  std::vector<PublishedRow> published;
};

/// The report of the run in `folder`, of which `run` was read, judged by the claims of its plan, or by those
/// of `other`. Throws RecordError where plan.json or machine.json cannot be read; a folder without
/// machine.json is of the machine that its records tell, or of an unknown one.
[[nodiscard]] JudgedRun judge_run(const std::filesystem::path& folder, const RunData& run,
                                  const std::optional<ClaimSheet>& other = {});
[[nodiscard]] JudgedRun judge_run(const std::filesystem::path& folder, const KernelData& run,
                                  const std::optional<ClaimSheet>& other = {});
[[nodiscard]] JudgedRun judge_run(const std::filesystem::path& folder, const AccuracyData& run,
                                  const std::optional<ClaimSheet>& other = {});
[[nodiscard]] JudgedRun judge_run(const std::filesystem::path& folder, const PixelsData& run,
                                  const std::optional<ClaimSheet>& other = {});

/// The verdicts for a terminal, after an empty line; empty where nothing is claimed.
[[nodiscard]] std::string verdicts_as_text(const JudgedRun& report);

/// Writes tables/claims.*, tables/published.* and report.json, which holds `tables` too; of what there is
/// nothing to say about there is no file. Throws std::runtime_error where one cannot be written whole.
void write_report(const std::filesystem::path& folder, const JudgedRun& report,
                  std::vector<NamedTable> tables);

}  // namespace raysweep
