// How a run gets its launches: an interface, so that tests run without processes.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "experiments/cell.h"
#include "results/record.h"

namespace raysweep {

/// What came of one launch: a record, or why there is none.
struct LaunchOutcome {
  std::optional<Record> record;
  std::string failure;       // set where there is no record
  bool interrupted = false;  // we were told to stop; neither record nor failure
};

class Launcher {
 public:
  virtual ~Launcher() = default;
  /// Runs `cell` once, timed for `seconds`. After `timeout_seconds` it is killed, a failure.
  virtual LaunchOutcome launch(const Cell& cell, double seconds, double timeout_seconds) = 0;
  /// Renders one frame of `cell`, cold.
  virtual LaunchOutcome picture(const Cell& cell, double timeout_seconds) = 0;
};

/// Each launch in fresh child processes of this program, `raysweep launch …`. The copies of a co-run cell
/// wait for each other before they time frames, and go on rendering until the last one has finished its own.
class ProcessLauncher final : public Launcher {
 public:
  LaunchOutcome launch(const Cell& cell, double seconds, double timeout_seconds) override;
  LaunchOutcome picture(const Cell& cell, double timeout_seconds) override;
};

}  // namespace raysweep
