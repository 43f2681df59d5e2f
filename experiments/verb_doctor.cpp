#include <fmt/core.h>

#include <nlohmann/json.hpp>

#include "experiments/errors.h"
#include "experiments/machine/findings.h"
#include "experiments/machine/machine.h"
#include "experiments/self_comparison.h"
#include "experiments/verbs.h"

namespace raysweep {

namespace {

constexpr double longest_watch = 3600;

struct DoctorOptions {
  double seconds = 2;
  int pairs = 20;
};

/// Launches a small cell twice, again and again: what differs is noise.
void compare_with_itself(Examination& examination, int processors, int pairs) {
  constexpr double launch_seconds = 0.1;
  ProcessLauncher launcher;
  const SelfComparison comparison =
      compare_with_itself(self_comparison_cell(processors), pairs, launch_seconds, launcher);
  if (comparison.failure.empty()) examination.noise = noise_floor(comparison.log_ratios, noise_launches);
  examination.noise_unknown = pairs == 0                    ? "not asked for (--pairs)"
                              : !comparison.failure.empty() ? comparison.failure
                                                            : examination.noise.to_text();
}

Examination examine(const DoctorOptions& options) {
  const Machine machine = detect_machine();
  Examination examination{
      machine.facts, build_facts(), timer_report(), watch_machine(options.seconds), {}, {}};
  compare_with_itself(examination, machine.topology.processors(), options.pairs);
  return examination;
}

nlohmann::json to_json(const Examination& examination, const std::vector<Finding>& findings) {
  nlohmann::json json{{"timer", to_json(examination.timer)},
                      {"facts", to_json(examination.facts)},
                      {"build", to_json(examination.build)},
                      {"watch", state_as_json(examination.watch.change)},
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
  Command verb = add_verb(line, "doctor", "is this machine fit to measure on, and what to do about it");
  static DoctorOptions options;
  verb.add_option("--seconds", options.seconds, "how long to watch the machine (default 2)");
  verb.add_option("--pairs", options.pairs,
                  "pairs of launches for the noise floor (default 20; 0: do without)")
      .range(0, 10000);
  verb.callback([&line] { line.action = [&line] { return run(options, line.json); }; });
}

}  // namespace raysweep
