// Records for tests.
#pragma once

#include "results/record.h"

namespace raysweep {

/// A valid launch with one frame of `seconds` in each of `processes`.
inline Record make_record(const std::string& scheduler, int threads, int round, double seconds,
                          int processes = 1) {
  Record r;
  r.experiment = "test";
  r.scene = "scene";
  r.mode = "hard";
  r.scheduler = scheduler;
  r.threads = r.threads_seen = threads;
  r.chunk = scheduler == "serial" ? "-" : "1";
  r.item = "rows";
  r.cell = scheduler + std::to_string(threads) + "x" + std::to_string(processes);
  r.round = round;
  r.processes = processes;
  r.machine = {"host", "cpu", 4, 2, 0.5};
  r.frame_seconds.assign(static_cast<size_t>(processes), {seconds});
  return r;
}

}  // namespace raysweep
