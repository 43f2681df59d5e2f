// One experiment while it runs: what is in its folder, and what its next rounds still need.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "experiments/config.h"
#include "experiments/plan.h"
#include "experiments/run_folder.h"

namespace raysweep {

/// Why a run ended.
enum class RunEnd { complete, out_of_budget, interrupted, failed };

struct RunReport {
  RunEnd end = RunEnd::complete;
  int launches = 0, void_launches = 0;
  std::string first_void;  // which of them was the first, and why
  int whole_rounds = 0;    // in which every cell took part that had to
};

/// An experiment that can be run: everything that can be refused has been.
struct Experiment {
  Config config;
  Plan plan;
  std::unique_ptr<RunFolder> folder;
};

class ExperimentRun {
 public:
  /// Takes up what the folder holds. `experiment` must outlive this.
  explicit ExperimentRun(const Experiment& experiment);

  /// The cells that `round` still lacks. In the first rounds all take part; later those that had not
  /// converged at the last look, with the cells that they are compared with. A function of the records of
  /// earlier rounds alone, so that a resumed run goes on as an undisturbed one would have.
  [[nodiscard]] std::vector<const PlannedCell*> missing(int round);

  /// Whether `round` or a later one lacks a launch, as far as today's records tell.
  [[nodiscard]] bool is_unfinished_from(int round);

  /// Writes the record of one launch of this round down, as this experiment's own.
  void take(Record record, int round);

  struct Widest {
    double relative_half_width;
    const PlannedCell* planned;
  };
  /// The cell whose interval is the widest so far; none as long as there is no interval.
  [[nodiscard]] std::optional<Widest> widest_interval() const;

  [[nodiscard]] const Config& config() const { return experiment_.config; }
  [[nodiscard]] const Plan& plan() const { return experiment_.plan; }

  RunReport report;

 private:
  [[nodiscard]] bool needs_more(const PlannedCell& planned, int look) const;
  void find_participants(int look);

  const Experiment& experiment_;
  std::map<std::string, std::map<int, double>> fps_;  // by cell and round, of valid launches
  std::vector<const PlannedCell*> participants_;
  int participants_of_look_ = -1;
};

/// "hard · omp_static 2 threads", for progress.
[[nodiscard]] std::string short_name(const Cell& cell);

}  // namespace raysweep
