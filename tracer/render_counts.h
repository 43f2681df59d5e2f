// What a picture cost in rays, and what it leaves out.
#pragma once

#include <algorithm>
#include <cstdint>

namespace raysweep {

/// Rays by what sent them out.
struct RayCounts {
  uint64_t primary = 0, shadow = 0, reflected = 0, refracted = 0;

  [[nodiscard]] uint64_t total() const { return primary + shadow + reflected + refracted; }
  RayCounts& operator+=(const RayCounts& other) {
    primary += other.primary;
    shadow += other.shadow;
    reflected += other.reflected;
    refracted += other.refracted;
    return *this;
  }
  friend bool operator==(const RayCounts&, const RayCounts&) = default;
};

/// Rays that were not traced though a surface would have sent them, by reason.
struct LeftOut {
  uint64_t by_depth = 0;      // one level deeper than the depth limit: they contribute nothing, by definition
  uint64_t by_tolerance = 0;  // all that was left of a sample could not have changed it beyond the tolerance
  uint64_t by_branches = 0;   // the sample had traced as many rays as it may
  double bound = 0;           // no channel of any sample lacks more than this through the last two
  uint64_t lost_media = 0;    // paths that left the scene though they were inside something

  LeftOut& operator+=(const LeftOut& other) {
    by_depth += other.by_depth;
    by_tolerance += other.by_tolerance;
    by_branches += other.by_branches;
    bound = std::max(bound, other.bound);
    lost_media += other.lost_media;
    return *this;
  }
  friend bool operator==(const LeftOut&, const LeftOut&) = default;
};

struct RenderCounts {
  RayCounts rays;
  LeftOut left_out;

  RenderCounts& operator+=(const RenderCounts& other) {
    rays += other.rays;
    left_out += other.left_out;
    return *this;
  }
  friend bool operator==(const RenderCounts&, const RenderCounts&) = default;
};

}  // namespace raysweep
