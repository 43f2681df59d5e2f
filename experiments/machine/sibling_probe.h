// Whether processors share a core, by what they do to each other: the topology of a virtual machine can lie.
#pragma once

#include <string>
#include <vector>

#include "schedulers/topology.h"

namespace raysweep {

/// How much longer the same work takes on two processors at once than on each alone.
struct PairSlowdown {
  int first, second;  // processors
  double slowdown;    // 1: they do not disturb each other; 2: each gets half
};

/// More have too many pairs to try in a minute.
inline constexpr int most_probed_processors = 128;

/// Every pair of `processors`, each bound to a thread that keeps the integer multiplier busy: the median of
/// a few tries, about 20 ms a pair. Throws SchedulerError where a thread cannot be bound.
[[nodiscard]] std::vector<PairSlowdown> probe_siblings(const std::vector<int>& processors);

/// Where the probe and the topology do not agree, one sentence a pair; empty if they agree everywhere.
[[nodiscard]] std::vector<std::string> disagreements(const std::vector<PairSlowdown>& pairs,
                                                     const Topology& topology);

}  // namespace raysweep
