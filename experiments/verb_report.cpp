#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <optional>

#include "experiments/errors.h"
#include "experiments/studies.h"
#include "experiments/verbs.h"
#include "results/plan_file.h"
#include "results/report_data.h"

namespace raysweep {

namespace {

struct ReportOptions {
  std::vector<std::string> folders;
  std::string claims;  // a config; empty: those that the run was planned with
};

/// Those of --claims. Throws RequestError where a folder holds another experiment.
std::optional<ClaimSheet> other_claims(const ReportOptions& options) {
  if (options.claims.empty()) return std::nullopt;
  NamedClaims claims = read_claims_of(options.claims, detect_machine());
  for (const std::string& folder : options.folders) {
    const std::string experiment = read_plan_file(folder).value("experiment", "");
    if (experiment == claims.experiment) continue;
    throw RequestError(fmt::format("{}: its claims are about experiment \"{}\"; {} holds \"{}\"",
                                   options.claims, claims.experiment, folder, experiment));
  }
  return std::move(claims.sheet);
}

int run(const ReportOptions& options, bool as_json) {
  const std::optional<ClaimSheet> claims = other_claims(options);
  auto json = nlohmann::json::array();
  for (const std::string& folder : options.folders) {
    if (report_study(folder, as_json ? &json : nullptr, claims)) continue;
    const RunData data = read_run(folder);
    const JudgedRun judged = judge_run(folder, data, claims);
    json.push_back({{"folder", folder},
                    {"rows", rows_as_json(data.rows, data.context.floor)},
                    {"claims", claims_as_json(judged.claims)}});
    if (!as_json) fmt::print("{}{}\n", tables_as_text(data.rows, data.context), verdicts_as_text(judged));
    write_report(folder, judged,
                 write_tables(data.rows, data.context, std::filesystem::path(folder) / "tables"));
  }
  if (as_json) fmt::print("{}\n", json.dump(1));
  return exit_done;
}

}  // namespace

void add_report(CommandLine& line) {
  Command verb =
      add_verb(line, "report", "the tables and verdicts of finished runs anew, from their records alone");
  static ReportOptions options;
  verb.add_option("folder", options.folders, "folders of runs").required();
  verb.add_option("--claims", options.claims, "a config whose claims are judged instead of the run's own");
  verb.callback([&line] { line.action = [&line] { return run(options, line.json); }; });
}

}  // namespace raysweep
