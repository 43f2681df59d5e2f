#include "experiments/estimate.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "experiments/errors.h"
#include "schedulers/registry.h"

namespace raysweep {

namespace {

/// Of the serial picture of a cell.
struct PictureTime {
  double frame_seconds;
  double other_seconds;  // starting a process, loading, building
};

class Estimator {
 public:
  Estimator(const MachineSize& machine, const RunnerTools& tools) : machine_(machine), tools_(tools) {}

  /// Of one launch that times frames for `seconds`.
  double launch_seconds(const Cell& cell, double seconds) {
    const PictureTime& picture = picture_time(cell);
    const int share = cell.processes > 1 ? 1 : std::min(cell.threads, machine_.pus);
    const double frame = picture.frame_seconds / share * (1 + cell.slowdown);
    constexpr double warmup_seconds = 0.05;
    const double warmup = std::max(frame * find_scheduler(cell.scheduler)->warmup_runs, warmup_seconds);
    const double timed = std::max(frame, seconds);
    // Serial launches measure their items in as much time again.
    const bool measures_items = cell.scheduler == "serial" && cell.processes == 1;
    return picture.other_seconds + warmup + timed * (measures_items ? 2 : 1);
  }

  [[nodiscard]] double pictures_seconds() const {
    double sum = 0;
    for (const auto& [key, picture] : pictures_) sum += picture.frame_seconds + picture.other_seconds;
    return sum;
  }

 private:
  const PictureTime& picture_time(const Cell& cell) {
    const std::string key = cell.picture_key();
    if (const auto known = pictures_.find(key); known != pictures_.end()) return known->second;
    constexpr int smaller = 8;
    Cell small = serial_cell(cell);
    small.settings.width = std::max(cell.settings.width / smaller, 1);
    small.settings.height = std::max(cell.settings.height / smaller, 1);
    constexpr double timeout = 600;
    const double begin = tools_.now();
    const LaunchOutcome outcome = tools_.launcher.picture(small, timeout);
    const double whole = tools_.now() - begin;
    if (!outcome.record)
      throw WorkError(fmt::format("the serial picture cannot be rendered ({}): {}", key, outcome.failure));
    const double frame = outcome.record->frame_seconds.front().front();
    const double pixels = double(cell.settings.width) * cell.settings.height,
                 small_pixels = double(small.settings.width) * small.settings.height;
    return pictures_.emplace(key, PictureTime{frame * pixels / small_pixels, std::max(0.0, whole - frame)})
        .first->second;
  }

  const MachineSize& machine_;
  const RunnerTools& tools_;
  std::map<std::string, PictureTime> pictures_;
};

}  // namespace

TimeEstimate estimate_time(const std::vector<Config>& configs, const std::vector<Plan>& plans,
                           const MachineSize& machine, const RunnerTools& tools) {
  struct Rounds {
    const Cell* cell;
    int first, all;
  };
  std::map<std::pair<std::string, double>, Rounds> cells;  // as the runner shares them
  for (size_t i = 0; i < plans.size(); ++i) {
    for (const PlannedCell& planned : plans[i].cells) {
      Rounds& rounds =
          cells.try_emplace({planned.key, configs[i].measure.seconds}, Rounds{&planned.cell, 0, 0})
              .first->second;
      rounds.first = std::max(rounds.first, plans[i].rounds);
      rounds.all = std::max(rounds.all, plans[i].max_rounds);
    }
  }
  Estimator estimator(machine, tools);
  TimeEstimate estimate;
  for (const auto& [key, rounds] : cells) {
    const double seconds = estimator.launch_seconds(*rounds.cell, key.second);
    estimate.first_rounds += seconds * rounds.first;
    estimate.all_rounds += seconds * rounds.all;
  }
  estimate.first_rounds += estimator.pictures_seconds();
  estimate.all_rounds += estimator.pictures_seconds();
  return estimate;
}

}  // namespace raysweep
