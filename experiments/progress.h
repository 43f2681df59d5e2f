// How far a run is, on standard error: a bar on a terminal, now and then a line elsewhere.
#pragma once

#include <string>

namespace raysweep {

class Progress {
 public:
  /// `unit` names what is counted, in plural. Seconds are those of the run's clock.
  Progress(std::string unit, double start_seconds, double budget_seconds, bool quiet);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// `done` of `total`, as far as that is known, are finished; `label` tells what comes next, `quality` how
  /// good what there is so far is, if anything can be said.
  void show(int done, int total, double now, const std::string& label, const std::string& quality = {});

 private:
  std::string unit_;
  double start_, budget_, last_ = 0;
  bool quiet_, terminal_;
};

/// Seconds left, from the pace so far, never more than the budget leaves. Negative: not known yet.
[[nodiscard]] double seconds_left(int done, int total, double elapsed, double budget);

/// "45 s", "2.5 min".
[[nodiscard]] std::string rough_duration(double seconds);

}  // namespace raysweep
