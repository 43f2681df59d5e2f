#include "experiments/kernel_verb.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "experiments/errors.h"
#include "experiments/progress.h"
#include "results/report_data.h"
#include "results/tables/kernel_tables.h"
#include "results/tables/tables.h"

namespace raysweep {

namespace {

nlohmann::json describe(const std::filesystem::path& folder, const KernelData& data,
                        const JudgedRun& judged) {
  return {{"folder", folder.string()},
          {"claims", claims_as_json(judged.claims)},
          {"rows", rows_as_json(kernel_data(data.results))}};
}

/// Reasons, on standard error. The exit code.
int tell_end(const KernelExperiment& experiment, const KernelReport& report) {
  const std::string& name = experiment.plan.experiment;
  const std::string folder = experiment.files->path().string();
  if (report.void_records > 0) {
    fmt::print(stderr, "{}: {} records void, and not timed; the first: {}\n", name, report.void_records,
               report.first_void);
  }
  const int code = report.void_records > 0 ? exit_failed : exit_done;
  switch (report.end) {
    case KernelEnd::complete:
      return code;
    case KernelEnd::out_of_budget:
      fmt::print(stderr,
                 "{}: the budget of {:.0f} s was used up after {} of {} records; --budget gives more, "
                 "--resume --out {} goes on.\n",
                 name, experiment.plan.measure.budget_seconds, report.records, record_count(experiment.plan),
                 folder);
      return code;
    case KernelEnd::interrupted:
      fmt::print(stderr,
                 "{}: interrupted: {} of {} records are finished and kept; go on with --resume --out {}.\n",
                 name, report.records, record_count(experiment.plan), folder);
      return exit_interrupted;
    case KernelEnd::failed:
      fmt::print(stderr, "raysweep: {}\n", report.failure);
      return exit_failed;
  }
  return code;
}

}  // namespace

int run_and_tell(const KernelExperiment& experiment, nlohmann::json* json) {
  const auto& [plan, files] = experiment;
  if (!json) {
    fmt::print(stderr, "{}: {} cells in {} rounds, at most {:.0f} s; records go to {}\n", plan.experiment,
               plan.cells.size(), plan.measure.rounds, plan.measure.budget_seconds, files->path().string());
  }
  const KernelReport report = run_kernels(experiment, json != nullptr);
  int code = tell_end(experiment, report);
  const KernelData data = read_kernel_run(files->path());
  const JudgedRun judged = judge_run(files->path(), data);
  if (json) {
    json->push_back(describe(files->path(), data, judged));
    json->back()["records"] = report.records;
    json->back()["void_records"] = report.void_records;
    json->back()["complete"] = report.end == KernelEnd::complete;
  } else {
    fmt::print("{}{}\nRecords, machine and tables: {}\n", kernel_tables_as_text(data),
               verdicts_as_text(judged), files->path().string());
  }
  try {
    write_report(files->path(), judged, write_kernel_tables(data, files->path() / "tables"));
  } catch (const std::exception& error) {  // a full disk must not hide what else there is to tell
    fmt::print(stderr, "raysweep: {}\n", error.what());
    code = std::max(code, exit_failed);
  }
  return code;
}

void dry_run_kernels(const KernelConfig& config, nlohmann::json* json) {
  const KernelPlan plan = make_plan(config);
  if (json) {
    json->push_back(to_json(plan));
    json->back()["estimate_seconds"] = estimate_seconds(plan);
    return;
  }
  fmt::print("{}About {}; the budget is {}.\n", plan_as_text(plan), rough_duration(estimate_seconds(plan)),
             rough_duration(plan.measure.budget_seconds));
}

void report_kernels(const std::filesystem::path& folder, nlohmann::json* json,
                    const std::optional<ClaimSheet>& claims) {
  const KernelData data = read_kernel_run(folder);
  const JudgedRun judged = judge_run(folder, data, claims);
  if (json) {
    json->push_back(describe(folder, data, judged));
  } else {
    fmt::print("{}{}\n", kernel_tables_as_text(data), verdicts_as_text(judged));
  }
  write_report(folder, judged, write_kernel_tables(data, folder / "tables"));
}

}  // namespace raysweep
