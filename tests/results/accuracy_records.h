// Made-up records of accuracy experiments.
#pragma once

#include <limits>
#include <string>

#include "results/accuracy_record.h"

namespace raysweep {

inline ErrorRecord no_errors() {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  return {0, nan, nan, nan, nan, nan};
}

/// A cell of 1000 rays with one triangle each, 400 of them hits, without a failure. At level 0 the difficulty
/// is 1, at level 1 a tenth, and so on.
inline AccuracyRecord made_up(const std::string& method, const std::string& case_id, int level,
                              const std::string& change = "base") {
  AccuracyRecord r;
  r.experiment = "x";
  r.method = method;
  r.change = change;
  r.variant = {"early", "exact", "distance_first", "inclusive", "yes", "weights", "bare"};
  r.precision = "float";
  r.case_id = case_id;
  r.difficulty_of = "size";
  r.level = level;
  r.difficulty = level == 0 ? 1 : level == 1 ? 0.1 : 0.01;
  r.rays = r.trials = 1000;
  r.hits = 400;
  r.t_error = {400, 0.5, 2, 3, 4, 0.75};
  r.uv_error = {400, 1e-7, 2e-7, 3e-7, 4e-7, 1.5e-7};
  r.weight_error = {800, 5, 20, 30, 40, 8};
  r.consistency = r.off_plane = no_errors();
  r.cell = method + '/' + change + '/' + r.precision + '/' + case_id + '/' + std::to_string(level);
  return r;
}

}  // namespace raysweep
