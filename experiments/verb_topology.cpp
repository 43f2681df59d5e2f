#include <fmt/core.h>

#include <nlohmann/json.hpp>

#include "experiments/errors.h"
#include "experiments/machine.h"
#include "experiments/verbs.h"

namespace raysweep {

namespace {

int run(int threads, bool json) {
  const Machine machine = detect_machine();
  if (json) {
    fmt::print("{}\n", to_json(machine).dump(1));
    return exit_done;
  }
  fmt::print("{}: {}, {}\n", machine.host, machine.cpu, machine.kernel);
  fmt::print("allowed here: {} packages, {} cores, {} processors{}\n\n", machine.packages, machine.cores,
             machine.pus, machine.pus > machine.cores ? "" : "; no hyper-threading");
  for (const std::string& object : machine.outline) fmt::print("{}\n", object);
  if (threads > 0) {
    fmt::print("\n{} threads, pin none: the operating system places them as it likes{}\n", threads,
               threads > machine.pus ? fmt::format("; {} more than there are processors (oversubscribed)",
                                                   threads - machine.pus)
                                     : "");
  }
  return exit_done;
}

}  // namespace

void add_topology(CommandLine& line) {
  CLI::App* const verb =
      add_verb(line, "topology", "the machine as hwloc sees it, and where each thread would go");
  static int threads = 0;
  static std::string pin = "none";
  verb->add_option("--threads", threads, "so many threads")->check(CLI::Range(1, 1024));
  verb->add_option("--pin", pin, "placed by this policy")->check(CLI::IsMember({"none"}));
  verb->callback([&line] { line.action = [&line] { return run(threads, line.json); }; });
}

}  // namespace raysweep
