// The clock of launches and runs.
#pragma once

#include <chrono>

namespace raysweep {

/// Seconds on a clock that never goes back.
[[nodiscard]] inline double now_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace raysweep
