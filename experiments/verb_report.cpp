#include <fmt/core.h>

#include "experiments/errors.h"
#include "experiments/verbs.h"
#include "results/run_data.h"

namespace raysweep {

namespace {

int run(const std::vector<std::string>& folders) {
  for (const std::string& folder : folders) {
    const RunData data = read_run(folder);
    write_tables(data.rows, data.context, std::filesystem::path(folder) / "tables");
    fmt::print("{}\n", tables_as_text(data.rows, data.context));
  }
  return exit_done;
}

}  // namespace

void add_report(CommandLine& line) {
  CLI::App* const verb =
      line.app.add_subcommand("report", "the tables of finished runs anew, from their records alone");
  static std::vector<std::string> folders;
  verb->add_option("folder", folders, "folders of runs")->required();
  verb->callback([&line] { line.action = [] { return run(folders); }; });
}

}  // namespace raysweep
