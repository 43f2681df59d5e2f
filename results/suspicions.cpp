#include "results/suspicions.h"

#include <algorithm>
#include <cmath>

namespace raysweep {

std::vector<std::string> suspicions(const CellRow& row, const NoiseFloor& floor) {
  if (!row.speedup || !row.speedup->interval || row.cell.scheduler == "serial") return {};
  const double low = row.speedup->interval->low;
  const int threads = row.cell.threads, processors = row.cell.processors_to_use();
  if (threads == 1) {
    if (std::log(low) <= floor.least_effect()) return {};
    return {
        "suspicious: faster than serial (the serial launches were disturbed, or its loop is compiled "
        "otherwise)"};
  }
  const int filled = processors > 0 ? std::min(threads, processors) : threads;
  if (low / filled <= suspicious_efficiency) return {};
  return {
      "suspicious: superlinear (more cache for each thread, a base that was slowed down, or work left out)"};
}

}  // namespace raysweep
