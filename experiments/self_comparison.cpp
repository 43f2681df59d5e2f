#include "experiments/self_comparison.h"

#include <cmath>

namespace raysweep {

Cell self_comparison_cell(int processors) {
  Cell cell;
  cell.scene = "studio";
  cell.settings.width = cell.settings.height = 256;
  cell.scheduler = processors > 1 ? "thread_dynamic" : "serial";
  cell.threads = processors;
  resolve_lights(cell);
  collapse_ignored_factors(cell);
  return cell;
}

SelfComparison compare_with_itself(const Cell& cell, int pairs, double seconds, Launcher& launcher) {
  constexpr double timeout_seconds = 60;  // such a launch takes a tenth of a second
  SelfComparison comparison;
  for (int pair = 0; pair < pairs; ++pair) {
    double log_fps[2];
    for (double& value : log_fps) {
      const LaunchOutcome outcome = launcher.launch(cell, seconds, timeout_seconds);
      if (outcome.record && outcome.record->valid) {
        value = std::log(outcome.record->fps());
        continue;
      }
      comparison.failure = outcome.interrupted ? "interrupted"
                           : outcome.record    ? outcome.record->reason
                                               : outcome.failure;
      return comparison;
    }
    comparison.log_ratios.push_back(log_fps[1] - log_fps[0]);
  }
  return comparison;
}

}  // namespace raysweep
