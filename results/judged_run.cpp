#include "results/judged_run.h"

#include <fmt/format.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "results/plan_file.h"
#include "results/report_data.h"
#include "results/tables/claims_tables.h"
#include "results/tables/table_files.h"
#include "results/tables/write_file.h"

namespace raysweep {

namespace {

namespace fs = std::filesystem;

/// None where there is no such file, as in folders of older programs.
std::optional<RunMachine> recorded_machine(const fs::path& folder) {
  const fs::path file = folder / "machine.json";
  std::ifstream in(file, std::ios::binary);
  if (!in) return std::nullopt;
  try {
    const auto json = nlohmann::json::parse(in);
    return RunMachine{json.at("host"), json.at("cpu"), {json.at("cores"), json.at("pus")}};
  } catch (const nlohmann::json::exception& error) {
    throw RecordError(fmt::format("{}: not a machine: {}", file.string(), error.what()));
  }
}

ClaimSheet sheet_of(const fs::path& folder) {
  try {
    return claim_sheet_of(read_plan_file(folder));
  } catch (const nlohmann::json::exception& error) {
    throw not_a_plan(folder, error.what());
  }
}

template <class Run>
JudgedRun start(const fs::path& folder, const Run& run, const std::string& experiment,
                const std::string& title, const std::string& kind, const std::optional<ClaimSheet>& other) {
  JudgedRun report;
  report.experiment = experiment;
  report.title = title;
  report.kind = kind;
  report.cells = measured_cells(run);
  report.machine = recorded_machine(folder).value_or(RunMachine());
  report.sheet = sheet_of(folder);
  if (other) {  // the question and the command are still those of the run
    report.sheet.claims = other->claims;
    report.sheet.published = other->published;
  }
  return report;
}

JudgedRun judged(JudgedRun report) {
  const Observations ours = observations_of(report.cells);
  report.claims = judge_all(report.sheet, ours, report.machine.counts);
  if (const auto& published = report.sheet.published) {
    const auto found = ours.find(published->quantity);
    report.published =
        published_rows(*published, found == ours.end() ? std::vector<Observation>() : found->second);
  }
  return report;
}

}  // namespace

JudgedRun judge_run(const fs::path& folder, const RunData& run, const std::optional<ClaimSheet>& other) {
  JudgedRun report = start(folder, run, run.context.experiment, run.context.title, "picture", other);
  report.noise_floor = run.context.floor.log_ratio;
  for (const CellRow& row : run.rows) {
    if (row.launches == 0) continue;
    // Launches know which processors they were allowed.
    const MachineRecord& machine = row.cell.machine;
    report.machine = {machine.host, machine.cpu, {machine.cores, machine.pus}};
    break;
  }
  return judged(std::move(report));
}

JudgedRun judge_run(const fs::path& folder, const KernelData& run, const std::optional<ClaimSheet>& other) {
  return judged(start(folder, run, run.experiment, run.title, "kernel", other));
}

JudgedRun judge_run(const fs::path& folder, const AccuracyData& run, const std::optional<ClaimSheet>& other) {
  return judged(start(folder, run, run.experiment, run.title, "accuracy", other));
}

JudgedRun judge_run(const fs::path& folder, const PixelsData& run, const std::optional<ClaimSheet>& other) {
  return judged(start(folder, run, run.experiment, run.title, "pixels", other));
}

std::string verdicts_as_text(const JudgedRun& report) {
  return report.claims.empty() ? std::string() : fmt::format("\n{}", claims_as_text(report.claims));
}

void write_report(const fs::path& folder, const JudgedRun& report, std::vector<NamedTable> tables) {
  const fs::path table_folder = folder / "tables";
  for (const char* name : {"claims", "published"}) remove_table(table_folder, name);
  if (!report.claims.empty()) {
    tables.push_back({"claims", claims_table(report.claims)});
    write_table(table_folder, "claims", tables.back().table, claims_data(report.claims));
  }
  if (report.sheet.published) {
    tables.push_back({"published", published_table(*report.sheet.published, report.published)});
    write_table(table_folder, "published", tables.back().table, published_data(report.published));
  }
  write_file(folder / "report.json", report_as_json(report, tables).dump(1) + "\n");
}

}  // namespace raysweep
