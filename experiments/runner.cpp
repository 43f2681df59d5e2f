#include "experiments/runner.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <memory>

#include "experiments/cell_record.h"
#include "experiments/errors.h"
#include "experiments/progress.h"

namespace raysweep {

namespace {

/// A serial picture, and how long its launch took.
struct Reference {
  Record record;
  double seconds;
};

/// One launch for all experiments whose round lacks it.
struct Turn {
  uint64_t at;
  const PlannedCell* planned;
  std::vector<ExperimentRun*> runs;
};

/// Voids a record whose picture or rays are not the serial ones.
void verify(Record& record, const Record& serial) {
  if (!record.valid) return;
  if (record.image_hash != serial.image_hash) {
    record.reason =
        fmt::format("picture {} differs from the serial one, {}", record.image_hash, serial.image_hash);
  } else if (record.rays != serial.rays) {
    record.reason = "its rays are not those of the serial picture";
  }
  record.valid = record.reason.empty();
}

/// Stands for a launch that left no record.
Record void_record(const Cell& cell, const std::string& reason) {
  Record r = record_of(cell);
  r.valid = false;
  r.reason = reason;
  return r;
}

/// A cell, and for how long its frames are timed: launches of other lengths are others.
using LaunchKey = std::pair<std::string, double>;

class Runner {
 public:
  Runner(const std::vector<Experiment>& experiments, const Machine& machine, const RunnerTools& tools)
      : machine_(machine), tools_(tools), start_(tools.now()) {
    for (const Experiment& experiment : experiments) {
      runs_.push_back(std::make_unique<ExperimentRun>(experiment));
      const Measure& measure = experiment.config.measure;
      budget_ += measure.budget_seconds;
      for (const PlannedCell& planned : experiment.plan.cells) {
        int& rounds = first_rounds_[{planned.key, measure.seconds}];
        rounds = std::max(rounds, experiment.plan.rounds);
      }
    }
  }

  RunOutcome run() {
    int last_round = 0, round = 0;
    for (const auto& run : runs_) last_round = std::max(last_round, run->plan().max_rounds);
    Progress progress("launches", start_, budget_, tools_.quiet);
    RunEnd end = RunEnd::complete;
    RunOutcome outcome;
    try {
      while (round < last_round && (end = run_round(round, progress)) == RunEnd::complete) round++;
    } catch (const WorkError& error) {
      outcome.failure = error.what();
      end = RunEnd::failed;
    }
    for (const auto& run : runs_) {
      if (end != RunEnd::complete && run->is_unfinished_from(round)) run->report.end = end;
      outcome.reports.push_back(run->report);
    }
    return outcome;
  }

 private:
  RunEnd run_round(int round, Progress& progress) {
    const std::vector<Turn> turns = turns_of(round);
    int total = launched_ + static_cast<int>(turns.size());
    // What comes after the rounds in which all take part is not known yet.
    for (const auto& [launch, rounds] : first_rounds_) total += std::max(0, rounds - round - 1);
    for (const Turn& turn : turns) {
      const double now = tools_.now();
      if (now - start_ >= budget_) return RunEnd::out_of_budget;
      progress.show(launched_, total, now, short_name(turn.planned->cell), widest_);
      if (!take(turn, round)) return RunEnd::interrupted;
      launched_++;
    }
    for (const auto& run : runs_) {
      if (round < run->plan().max_rounds) run->report.whole_rounds = round + 1;
    }
    widest_ = widest_interval();
    return RunEnd::complete;
  }

  [[nodiscard]] std::string widest_interval() const {
    std::optional<ExperimentRun::Widest> widest;
    for (const auto& run : runs_) {
      const auto of_run = run->widest_interval();
      if (of_run && (!widest || of_run->relative_half_width > widest->relative_half_width)) widest = of_run;
    }
    if (!widest) return {};
    return fmt::format("widest interval ±{:.1f} %: {}", widest->relative_half_width * 100,
                       short_name(widest->planned->cell));
  }

  std::vector<Turn> turns_of(int round) {
    std::map<LaunchKey, Turn> turns;
    for (const auto& run : runs_) {
      for (const PlannedCell* const planned : run->missing(round)) {
        Turn& turn = turns[{planned->key, run->config().measure.seconds}];
        if (turn.runs.empty()) turn = {raysweep::turn(run->plan().seed, round, planned->key), planned, {}};
        turn.runs.push_back(run.get());
      }
    }
    std::vector<Turn> order;
    for (auto& [key, turn] : turns) order.push_back(std::move(turn));
    std::ranges::stable_sort(order, {}, &Turn::at);
    return order;
  }

  /// The longest that an experiment of this turn allows; one that does not say allows `otherwise`.
  static double timeout_of(const Turn& turn, double otherwise) {
    double longest = 0;
    for (const ExperimentRun* const run : turn.runs) {
      const double own = run->config().measure.timeout_seconds;
      longest = std::max(longest, own > 0 ? own : otherwise);
    }
    return longest;
  }

  /// The serial picture of the turn's cell, rendered once; null when interrupted.
  const Reference* reference(const Turn& turn) {
    const Cell& cell = turn.planned->cell;
    const std::string key = cell.picture_key();
    if (const auto known = references_.find(key); known != references_.end()) return &known->second;
    // How long it takes is not known yet; what takes longer than all there is cannot be measured anyway.
    const double timeout = timeout_of(turn, std::max(budget_, 60.0));
    const double begin = tools_.now();
    LaunchOutcome outcome = tools_.launcher.picture(serial_cell(cell), timeout);
    if (outcome.interrupted) return nullptr;
    if (!outcome.record) {
      throw WorkError(fmt::format("the serial picture cannot be rendered ({}): {}", key, outcome.failure));
    }
    const double seconds = tools_.now() - begin;
    return &references_.emplace(key, Reference{std::move(*outcome.record), seconds}).first->second;
  }

  /// One launch, verified and written down. False when interrupted.
  bool take(const Turn& turn, int round) {
    const Cell& cell = turn.planned->cell;
    const double seconds = turn.runs.front()->config().measure.seconds;  // all have the same
    const Reference* const serial = reference(turn);
    if (!serial) return false;
    const double timeout = timeout_of(turn, default_timeout(cell, seconds, serial->seconds));
    const MachineRecord machine = machine_record(machine_);
    const double begin = tools_.now();
    LaunchOutcome outcome = tools_.launcher.launch(cell, seconds, timeout);
    if (outcome.interrupted) return false;
    Record record = outcome.record ? std::move(*outcome.record) : void_record(cell, outcome.failure);
    verify(record, serial->record);
    record.launch_seconds = tools_.now() - begin;
    record.machine = machine;
    for (ExperimentRun* const run : turn.runs) run->take(record, round);
    return true;
  }

  const Machine& machine_;
  const RunnerTools& tools_;
  const double start_;
  double budget_ = 0;
  std::map<LaunchKey, int> first_rounds_;
  std::vector<std::unique_ptr<ExperimentRun>> runs_;
  std::map<std::string, Reference> references_;
  int launched_ = 0;
  std::string widest_;  // interval so far, as text
};

}  // namespace

double default_timeout(const Cell& cell, double seconds, double picture_seconds) {
  // A picture is one cold frame; a launch warms up for two or three, times one or more, and serial ones time
  // their items as long again: below ten pictures and twice the seconds on a quiet machine.
  constexpr double pictures = 20, timed = 4, least = 60;
  return least + (pictures * picture_seconds + timed * seconds) * cell.processes * (1 + cell.slowdown);
}

RunOutcome run_experiments(const std::vector<Experiment>& experiments, const Machine& machine,
                           const RunnerTools& tools) {
  return Runner(experiments, machine, tools).run();
}

}  // namespace raysweep
