#include "experiments/verbs.h"

#include <fmt/format.h>

#include "experiments/errors.h"

namespace raysweep {

Command add_verb(CommandLine& line, const std::string& name, const std::string& summary) {
  Command verb = line.app.add_subcommand(name, summary);
  verb.add_flag("--json", line.json,
                "one JSON document on standard output, everything else on standard error");
  return verb;
}

void add_all_verbs(CommandLine& line) {
  line.app.require_subcommand(1, 1);
  line.app.set_version_flag("--version", RAYSWEEP_VERSION);
  for (const auto add : {add_run, add_render, add_list, add_topology, add_doctor, add_report, add_compare,
                         add_peers, add_advise, add_launch})
    add(line);
}

void refuse_unknown_verb(const CommandLine& line, int argc, char** argv) {
  if (argc < 2 || argv[1][0] == '-') return;
  std::string known;
  for (const std::string& verb : line.app.subcommand_names()) {
    if (verb == argv[1]) return;
    known += fmt::format("{}{}", known.empty() ? "" : ", ", verb);
  }
  throw RequestError(fmt::format("unknown verb \"{}\"; possible: {}", argv[1], known));
}

}  // namespace raysweep
