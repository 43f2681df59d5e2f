#include "experiments/experiment_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "results/statistics/statistics.h"
#include "results/statistics/stopping.h"
#include "tracer/hash.h"

namespace raysweep {

namespace {

/// How many rounds decide whether a cell takes part in `round`: those up to the last look before it.
int last_look(const Plan& plan, int round) {
  int look = plan.rounds;
  while (true) {
    const int next = next_look(look, plan.rounds, plan.max_rounds);
    if (next <= look || next > round) return look;
    look = next;
  }
}

/// Co-run cells and twins come along with those that they are for.
bool serves_others(const Cell& cell) { return cell.processes > 1 || cell.twin > 0; }

}  // namespace

std::string short_name(const Cell& cell) {
  if (cell.processes > 1) return fmt::format("{} · {} × serial", cell.mode, cell.processes);
  return fmt::format("{} · {} {} {}{}", cell.mode, cell.scheduler, cell.threads,
                     cell.threads == 1 ? "thread" : "threads", cell.twin > 0 ? " (twin)" : "");
}

ExperimentRun::ExperimentRun(const Experiment& experiment) : experiment_(experiment) {
  for (const Record& r : experiment.folder->records()) {
    if (r.valid) fps_[r.cell][r.round] = r.fps();  // void ones are tried again
  }
  report.launches = static_cast<int>(experiment.folder->records().size());
}

bool ExperimentRun::needs_more(const PlannedCell& planned, int look) const {
  if (serves_others(planned.cell)) return false;
  const auto found = fps_.find(planned.key);
  if (found == fps_.end()) return false;  // it never was valid: more rounds would not make it so
  std::vector<double> samples;
  for (const auto& [round, fps] : found->second) {
    if (round < look) samples.push_back(fps);
  }
  return !samples.empty() && !converged(estimate_median(std::move(samples)), plan().interval);
}

void ExperimentRun::find_participants(int look) {
  std::set<std::string> keys;
  for (const PlannedCell& planned : plan().cells) {
    if (!needs_more(planned, look)) continue;
    keys.insert(planned.key);
    keys.insert(planned.bases.begin(), planned.bases.end());
  }
  participants_.clear();
  for (const PlannedCell& planned : plan().cells) {
    if (keys.contains(planned.key)) participants_.push_back(&planned);
  }
  participants_of_look_ = look;
}

std::vector<const PlannedCell*> ExperimentRun::missing(int round) {
  std::vector<const PlannedCell*> list;
  if (round >= plan().max_rounds) return list;
  if (round < plan().rounds) {
    for (const PlannedCell& planned : plan().cells) list.push_back(&planned);
  } else {
    if (const int look = last_look(plan(), round); look != participants_of_look_) find_participants(look);
    list = participants_;
  }
  std::erase_if(list, [&](const PlannedCell* planned) {
    const auto found = fps_.find(planned->key);
    return found != fps_.end() && found->second.contains(round);
  });
  return list;
}

bool ExperimentRun::is_unfinished_from(int round) {
  for (; round < plan().max_rounds; ++round) {
    if (!missing(round).empty()) return true;
  }
  return false;
}

void ExperimentRun::take(Record record, int round) {
  record.experiment = config().experiment;
  record.launch = report.launches++;
  record.round = round;
  record.seed = plan().seed;
  record.config_hash = hash_of(config().text);
  if (!record.valid && report.void_launches++ == 0) {
    const auto planned = std::ranges::find(plan().cells, record.cell, &PlannedCell::key);
    report.first_void = fmt::format("{}: {}", short_name(planned->cell), record.reason);
  }
  if (record.valid) fps_[record.cell][round] = record.fps();
  experiment_.folder->append(record);
}

std::optional<ExperimentRun::Widest> ExperimentRun::widest_interval() const {
  std::optional<Widest> widest;
  for (const PlannedCell& planned : plan().cells) {
    const auto found = fps_.find(planned.key);
    if (serves_others(planned.cell) || found == fps_.end() || found->second.empty()) continue;
    std::vector<double> samples;
    for (const auto& [round, fps] : found->second) samples.push_back(fps);
    const auto width = estimate_median(std::move(samples)).relative_half_width();
    if (width && (!widest || *width > widest->relative_half_width)) widest = {*width, &planned};
  }
  return widest;
}

}  // namespace raysweep
