#include "experiments/accuracy_verb.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "experiments/errors.h"
#include "experiments/progress.h"
#include "results/report_data.h"
#include "results/tables/accuracy_tables.h"
#include "results/tables/contract_tables.h"
#include "results/tables/tables.h"

namespace raysweep {

namespace {

/// Broken promises are findings: they change no exit code of a run. Tests are what they fail.
Contract promised() { return Contract::read(RAYSWEEP_CONTRACT); }

nlohmann::json describe(const std::filesystem::path& folder, const AccuracyData& data,
                        const Contract& contract, const JudgedRun& judged) {
  return {{"folder", folder.string()},
          {"claims", claims_as_json(judged.claims)},
          {"rows", rows_as_json(accuracy_data(data.results))},
          {"contract", rows_as_json(contract_table(data.results, contract))},
          {"contract_differences", rows_as_json(contract_differences_table(data.results, contract))}};
}

/// Progress and reasons, on standard error. The exit code.
int tell_end(const AccuracyExperiment& experiment, const AccuracyReport& report) {
  const std::string& name = experiment.plan.settings.experiment;
  if (!report.failure.empty()) {
    fmt::print(stderr, "raysweep: {}\n", report.failure);
    return exit_failed;
  }
  if (!report.was_interrupted) return exit_done;
  fmt::print(stderr, "{}: interrupted: {} of {} cells are finished and kept; go on with --resume --out {}.\n",
             name, report.cells, experiment.plan.cell_count(), experiment.files->path().string());
  return exit_interrupted;
}

}  // namespace

int run_and_tell(const AccuracyExperiment& experiment, nlohmann::json* json) {
  const auto& [plan, files] = experiment;
  const Contract contract = promised();
  if (!json) {
    fmt::print(stderr, "{}: {} cells of {} rays; records go to {}\n", plan.settings.experiment,
               plan.cell_count(), plan.settings.ray_count, files->path().string());
  }
  const AccuracyReport report = run_accuracy(experiment, json != nullptr);
  int code = tell_end(experiment, report);
  const AccuracyData data = read_accuracy_run(files->path());
  const JudgedRun judged = judge_run(files->path(), data);
  if (json) {
    json->push_back(describe(files->path(), data, contract, judged));
    json->back()["complete"] = report.cells == plan.cell_count();
  } else {
    fmt::print("{}{}\nRecords, machine and tables: {}\n", accuracy_tables_as_text(data, contract),
               verdicts_as_text(judged), files->path().string());
  }
  try {
    write_report(files->path(), judged, write_accuracy_tables(data, contract, files->path() / "tables"));
  } catch (const std::exception& error) {  // a full disk must not hide what else there is to tell
    fmt::print(stderr, "raysweep: {}\n", error.what());
    code = std::max(code, exit_failed);
  }
  return code;
}

void dry_run_accuracy(const AccuracyConfig& config, nlohmann::json* json) {
  const AccuracyPlan plan = make_plan(config);
  if (json) {
    json->push_back(to_json(plan));
    json->back()["threads"] = plan.threads;
    json->back()["estimate_seconds"] = estimate_seconds(plan);
    return;
  }
  fmt::print("{}", plan_as_text(plan));
  fmt::print("About {}.\n", rough_duration(estimate_seconds(plan)));
}

void report_accuracy(const std::filesystem::path& folder, nlohmann::json* json,
                     const std::optional<ClaimSheet>& claims) {
  const AccuracyData data = read_accuracy_run(folder);
  const JudgedRun judged = judge_run(folder, data, claims);
  const Contract contract = promised();
  if (json) {
    json->push_back(describe(folder, data, contract, judged));
  } else {
    fmt::print("{}{}\n", accuracy_tables_as_text(data, contract), verdicts_as_text(judged));
  }
  write_report(folder, judged, write_accuracy_tables(data, contract, folder / "tables"));
}

}  // namespace raysweep
