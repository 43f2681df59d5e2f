#include "experiments/pixels_verb.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "experiments/errors.h"
#include "results/report_data.h"
#include "results/tables/pixels_tables.h"
#include "results/tables/tables.h"

namespace raysweep {

namespace {

nlohmann::json describe(const std::filesystem::path& folder, const PixelsData& data,
                        const JudgedRun& judged) {
  return {{"folder", folder.string()},
          {"claims", claims_as_json(judged.claims)},
          {"rows", rows_as_json(pixels_data(data.rows))}};
}

size_t record_count(const PixelsConfig& config) {
  return config.cell_count() * static_cast<size_t>(config.settings.rounds);
}

/// Reasons, on standard error. The exit code.
int tell_end(const PixelsExperiment& experiment, const PixelsReport& report) {
  const auto& [config, files] = experiment;
  if (!report.failure.empty()) {
    fmt::print(stderr, "raysweep: {}\n", report.failure);
    return exit_failed;
  }
  if (report.was_interrupted) {
    fmt::print(
        stderr,
        "{}: interrupted: {} of {} measurements are finished and kept; go on with --resume --out {}.\n",
        config.settings.experiment, report.records, record_count(config), files->path().string());
    return exit_interrupted;
  }
  if (report.void_records > 0) {
    fmt::print(stderr, "{}: {} measurements are void: a frame was not the picture that it should have been\n",
               config.settings.experiment, report.void_records);
    return exit_failed;
  }
  return exit_done;
}

}  // namespace

int run_and_tell(const PixelsExperiment& experiment, nlohmann::json* json) {
  const auto& [config, files] = experiment;
  if (!json) {
    fmt::print(stderr, "{}: {} cells in {} rounds; records go to {}\n", config.settings.experiment,
               config.cell_count(), config.settings.rounds, files->path().string());
  }
  const PixelsReport report = run_pixels(experiment, json != nullptr);
  int code = tell_end(experiment, report);
  const PixelsData data = read_pixels_run(files->path());
  const JudgedRun judged = judge_run(files->path(), data);
  if (json) {
    json->push_back(describe(files->path(), data, judged));
    json->back()["complete"] = report.records == record_count(config);
  } else {
    fmt::print("{}{}\nRecords, machine, pictures and tables: {}\n", pixels_tables_as_text(data),
               verdicts_as_text(judged), files->path().string());
  }
  try {
    write_report(files->path(), judged, write_pixels_tables(data, files->path() / "tables"));
  } catch (const std::exception& error) {  // a full disk must not hide what else there is to tell
    fmt::print(stderr, "raysweep: {}\n", error.what());
    code = std::max(code, exit_failed);
  }
  return code;
}

void dry_run_pixels(const PixelsConfig& config, nlohmann::json* json) {
  // Frames that take longer than this, references and what is built come on top.
  const double seconds = static_cast<double>(record_count(config)) * config.settings.seconds;
  if (json) {
    json->push_back(to_json(config));
    json->back()["estimate_seconds"] = seconds;
    return;
  }
  fmt::print("{}: {}\n{} cells in {} rounds; seed {}\n", config.settings.experiment, config.title,
             config.cell_count(), config.settings.rounds, config.settings.seed);
  const nlohmann::json plan = to_json(config);
  for (const auto& key : plan.at("cells")) fmt::print("{}\n", key.get<std::string>());
  for (const std::string& one : config.left_out) fmt::print("left out: {}\n", one);
  fmt::print("At least {:.0f} s.\n", seconds);
}

void report_pixels(const std::filesystem::path& folder, nlohmann::json* json,
                   const std::optional<ClaimSheet>& claims) {
  const PixelsData data = read_pixels_run(folder);
  const JudgedRun judged = judge_run(folder, data, claims);
  if (json) {
    json->push_back(describe(folder, data, judged));
  } else {
    fmt::print("{}{}\n", pixels_tables_as_text(data), verdicts_as_text(judged));
  }
  write_report(folder, judged, write_pixels_tables(data, folder / "tables"));
}

}  // namespace raysweep
