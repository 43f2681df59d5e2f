#include <fmt/core.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "experiments/clock.h"
#include "experiments/errors.h"
#include "experiments/estimate.h"
#include "experiments/interrupt.h"
#include "experiments/progress.h"
#include "experiments/run_request.h"
#include "experiments/runner.h"
#include "experiments/verbs.h"
#include "results/report_data.h"
#include "results/run_data.h"

namespace raysweep {

namespace {

void print_plan(const Config& config, const Plan& plan) {
  fmt::print(
      "{}: {}\n{} cells, each launched {} times, up to {} where intervals stay wider than ±{:.3g} %; seed "
      "{}\n",
      config.experiment, config.title, plan.cells.size(), plan.rounds, plan.max_rounds, plan.interval * 100,
      plan.seed);
  for (const PlannedCell& planned : plan.cells)
    fmt::print("{}{}\n", planned.key, planned.asked ? "" : planned.cell.twin > 0 ? "  (twin)" : "  (base)");
}

std::string advice(const RunReport& report, const Experiment& experiment, double budget_seconds) {
  const auto& [config, plan, folder] = experiment;
  switch (report.end) {
    case RunEnd::complete:
      return {};
    case RunEnd::out_of_budget:
      return fmt::format(
          "{}: the budget of {:.0f} s was used up after {} rounds ({} are the least, {} the most, for what "
          "does not converge); --budget gives more, --resume --out {} goes on.",
          config.experiment, budget_seconds, report.whole_rounds, plan.rounds, plan.max_rounds,
          folder->path().string());
    case RunEnd::interrupted:
    case RunEnd::failed:
      return fmt::format("{}: {}: {} finished launches are kept; go on with --resume --out {}.",
                         config.experiment, report.end == RunEnd::failed ? "failed" : "interrupted",
                         report.launches, folder->path().string());
  }
  return {};
}

nlohmann::json describe(const Experiment& experiment, const RunReport& report, const RunData& data,
                        const JudgedRun& judged) {
  return {{"folder", experiment.folder->path().string()},
          {"launches", report.launches},
          {"void_launches", report.void_launches},
          {"complete", report.end == RunEnd::complete},
          {"rows", rows_as_json(data.rows, data.context.floor)},
          {"claims", claims_as_json(judged.claims)}};
}

/// On standard output the tables of one experiment, or a document in `json`. The exit code.
int tell(const Experiment& experiment, const RunReport& report, double budget_seconds, nlohmann::json* json) {
  const RunData data = read_run(experiment.folder->path());
  const JudgedRun judged = judge_run(experiment.folder->path(), data);
  if (json) {
    json->push_back(describe(experiment, report, data, judged));
  } else {
    fmt::print("{}{}\nRecords, machine and tables: {}\n", tables_as_text(data.rows, data.context),
               verdicts_as_text(judged), experiment.folder->path().string());
  }
  if (report.void_launches > 0) {
    fmt::print(stderr, "{}: {} of {} launches void; the first: {}\n", experiment.config.experiment,
               report.void_launches, report.launches, report.first_void);
  }
  const std::string text = advice(report, experiment, budget_seconds);
  if (!text.empty()) fmt::print(stderr, "{}\n", text);
  int code = report.void_launches > 0 || report.end == RunEnd::failed ? exit_failed : exit_done;
  try {
    write_report(experiment.folder->path(), judged,
                 write_tables(data.rows, data.context, experiment.folder->path() / "tables"));
  } catch (const std::exception& error) {  // a full disk must not hide what else there is to tell
    fmt::print(stderr, "raysweep: {}\n", error.what());
    code = exit_failed;
  }
  return report.end == RunEnd::interrupted ? exit_interrupted : code;
}

/// Runs, then tells. The exit code.
int run_all(const std::vector<Experiment>& experiments, const Machine& machine, nlohmann::json* json) {
  double budget = 0;
  for (const Experiment& experiment : experiments) budget += experiment.config.measure.budget_seconds;
  for (const auto& [config, plan, folder] : experiments) {
    if (json) break;
    fmt::print(stderr, "{}: {} cells in {} rounds or more, at most {:.0f} s{}; records go to {}\n",
               config.experiment, plan.cells.size(), plan.rounds, budget,
               experiments.size() > 1 ? " for all experiments" : "", folder->path().string());
  }
  ProcessLauncher launcher;
  const auto [reports, failure] =
      run_experiments(experiments, machine, {launcher, now_seconds, json != nullptr});
  if (!failure.empty()) fmt::print(stderr, "raysweep: {}\n", failure);
  int worst = exit_done;
  for (size_t i = 0; i < experiments.size(); ++i)
    worst = std::max(worst, tell(experiments[i], reports[i], budget, json));
  return failure.empty() ? worst : exit_failed;
}

std::vector<Experiment> prepare(RunRequest& request, bool resume, const Machine& machine) {
  std::vector<Experiment> list;
  // Every plan before the first folder: what one refuses leaves nothing of the others.
  for (Config& config : request.pictures) {
    Plan plan = make_plan(config, machine.size());
    list.push_back({std::move(config), std::move(plan), nullptr});
  }
  for (Experiment& p : list) {
    p.folder = std::make_unique<RunFolder>(request.folders.at(p.config.experiment), p.config, p.plan, machine,
                                           resume);
  }
  return list;
}

/// What would be launched, and how long it might take.
void dry_run(const std::vector<Config>& configs, const Machine& machine, nlohmann::json* json) {
  std::vector<Plan> plans;
  double budget = 0;
  for (const Config& config : configs) {
    plans.push_back(make_plan(config, machine.size()));
    budget += config.measure.budget_seconds;
  }
  ProcessLauncher launcher;
  const RunnerTools tools{launcher, now_seconds, true};
  for (size_t i = 0; i < configs.size(); ++i) {
    if (json) {
      json->push_back(to_json(plans[i]));
      json->back()["estimate_seconds"] =
          estimate_time({configs[i]}, {plans[i]}, machine.size(), tools).first_rounds;
      json->back()["budget_seconds"] = configs[i].measure.budget_seconds;
    } else {
      print_plan(configs[i], plans[i]);
    }
  }
  if (json || configs.empty()) return;
  const TimeEstimate estimate = estimate_time(configs, plans, machine.size(), tools);
  fmt::print("About {} for the first rounds of {}, up to {} if nothing converges before; the budget is {}.\n",
             rough_duration(estimate.first_rounds), configs.size() > 1 ? "all experiments" : "all cells",
             rough_duration(estimate.all_rounds), rough_duration(budget));
}

void drop_unanswerable(std::vector<Config>& configs, nlohmann::json& json, bool as_json) {
  std::erase_if(configs, [&](const Config& config) {
    if (config.not_here.empty()) return false;
    json.push_back({{"experiment", config.experiment}, {"not_run", config.not_here}});
    if (!as_json) fmt::print("{}: not run: {}.\n", config.experiment, config.not_here);
    return true;
  });
}

/// All folders are made before anything runs. The exit code.
int run_request(RunRequest request, bool resume, const Machine& machine, nlohmann::json* json) {
  catch_interrupts();
  const std::vector<Experiment> pictures = prepare(request, resume, machine);
  for (const auto& study : request.studies)
    study->open(request.folders.at(study->experiment()), machine, resume);
  int code = pictures.empty() ? exit_done : run_all(pictures, machine, json);
  for (const auto& study : request.studies) code = std::max(code, study->run_and_tell(json));
  return code;
}

int run(const RunOptions& options, bool as_json) {
  if (options.resume && options.out.empty())
    throw RequestError("--resume goes on with the run in --out: name its folder");
  const Machine machine = detect_machine();
  RunRequest request = read_request(options, machine);
  nlohmann::json list = nlohmann::json::array();
  nlohmann::json* const json = as_json ? &list : nullptr;
  drop_unanswerable(request.pictures, list, as_json);
  int code = exit_done;
  if (options.dry_run) {
    dry_run(request.pictures, machine, json);
    for (const auto& study : request.studies) study->dry_run(json);
  } else {
    code = run_request(std::move(request), options.resume, machine, json);
  }
  if (as_json) fmt::print("{}\n", list.dump(1));
  return code;
}

}  // namespace

void add_run(CommandLine& line) {
  Command verb = add_verb(line, "run", "runs experiments: tables at the end, everything into a folder");
  static RunOptions options;
  verb.add_option("config", options.files, "experiment files (TOML), or lists of them").required();
  verb.add_option("--out", options.out,
                  "folder of the run (default: results/runs/EXPERIMENT-TIME); of several, of their folders");
  verb.add_flag("--resume", options.resume, "go on with the run in --out");
  verb.add_flag("--quick", options.quick,
                "a smaller run: what the [quick] of each experiment says, then --set");
  verb.add_flag("--dry-run", options.dry_run, "print the cells and how long they would take; write nothing");
  verb.add_option("--budget", options.budget_minutes,
                  "minutes for each experiment, of a list for all that it includes; pictures share the sum")
      .above_0();
  verb.add_option("--seed", options.seed, "seed of the launches' order");
  verb.add_option("--set", options.overrides,
                  "KEY=VALUE: change the config, such as threads=1..4 or measure.launches=3")
      .repeated();
  verb.callback([&line] { line.action = [&line] { return run(options, line.json); }; });
}

}  // namespace raysweep
