#include <fmt/core.h>

#include <nlohmann/json.hpp>

#include "experiments/errors.h"
#include "experiments/findings.h"
#include "experiments/machine.h"
#include "experiments/verbs.h"

namespace raysweep {

namespace {

constexpr double longest_watch = 3600;

struct DoctorOptions {
  double seconds = 2;
};

Examination examine(const DoctorOptions& options) {
  return {detect_machine().facts, build_facts(), timer_report(), watch_machine(options.seconds)};
}

nlohmann::json to_json(const Examination& examination, const std::vector<Finding>& findings) {
  nlohmann::json json{{"timer", to_json(examination.timer)},
                      {"facts", to_json(examination.facts)},
                      {"build", to_json(examination.build)},
                      {"watch", to_json(examination.watch.change)},
                      {"verdict", verdict(findings)}};
  json["findings"] = nlohmann::json::array();
  for (const Finding& finding : findings) json["findings"].push_back(to_json(finding));
  return json;
}

void print(const std::vector<Finding>& findings) {
  fmt::print("{}", to_text(table_of(findings)));
  for (const Finding& finding : findings)
    if (!finding.advice.empty()) fmt::print("\n{}: {}\n", finding.name, finding.advice);
  fmt::print("\n{}\n", verdict(findings));
}

int run(const DoctorOptions& options, bool as_json) {
  // Written so that what is no number is refused, too.
  if (!(options.seconds >= least_window_seconds && options.seconds <= longest_watch)) {
    throw RequestError(fmt::format("seconds = {} is out of range: a number from {} to {} is possible",
                                   options.seconds, least_window_seconds, longest_watch));
  }
  const Examination examination = examine(options);
  const std::vector<Finding> findings = judge(examination);
  if (as_json) {
    fmt::print("{}\n",
               to_json(examination, findings).dump(1, ' ', false, nlohmann::json::error_handler_t::replace));
  } else {
    print(findings);
  }
  return exit_done;
}

}  // namespace

void add_doctor(CommandLine& line) {
  CLI::App* const verb =
      add_verb(line, "doctor", "is this machine fit to measure on, and what to do about it");
  static DoctorOptions options;
  verb->add_option("--seconds", options.seconds, "how long to watch the machine (default 2)");
  verb->callback([&line] { line.action = [&line] { return run(options, line.json); }; });
}

}  // namespace raysweep
