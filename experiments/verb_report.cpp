#include <fmt/core.h>

#include <nlohmann/json.hpp>

#include "experiments/errors.h"
#include "experiments/studies.h"
#include "experiments/verbs.h"
#include "results/run_data.h"

namespace raysweep {

namespace {

int run(const std::vector<std::string>& folders, bool as_json) {
  auto json = nlohmann::json::array();
  for (const std::string& folder : folders) {
    if (report_study(folder, as_json ? &json : nullptr)) continue;
    const RunData data = read_run(folder);
    json.push_back({{"folder", folder}, {"rows", rows_as_json(data.rows, data.context.floor)}});
    if (!as_json) fmt::print("{}\n", tables_as_text(data.rows, data.context));
    write_tables(data.rows, data.context, std::filesystem::path(folder) / "tables");
  }
  if (as_json) fmt::print("{}\n", json.dump(1));
  return exit_done;
}

}  // namespace

void add_report(CommandLine& line) {
  Command verb = add_verb(line, "report", "the tables of finished runs anew, from their records alone");
  static std::vector<std::string> folders;
  verb.add_option("folder", folders, "folders of runs").required();
  verb.callback([&line] { line.action = [&line] { return run(folders, line.json); }; });
}

}  // namespace raysweep
