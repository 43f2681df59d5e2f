// Which thread runs on which processor: policies over a topology.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "schedulers/topology.h"

namespace raysweep {

struct PinPolicy {
  std::string_view name, summary;
};

/// The policies that have a name; an explicit list of processors, "0,2,4-7", is one more.
[[nodiscard]] std::span<const PinPolicy> pin_policies();

/// What is wrong with `pin` where these processors are allowed, as a sentence; empty if nothing is. With an
/// empty list, any are.
[[nodiscard]] std::string pin_problem(const std::string& pin, const std::vector<int>& allowed);

/// The processor of each of `threads` workers; empty for "none". With more threads than the policy has
/// processors it begins anew with the first. For a `pin` without a problem.
[[nodiscard]] std::vector<int> place(const std::string& pin, int threads, const Topology& topology);

/// The placements that tell what hyper-threading gives, on `cores` cores that have two hardware threads or
/// more: as many threads as cores, one on each; twice as many, two on each; and as many as cores on half of
/// them, two on each.
struct HyperThreadingPlacements {
  int cores;
  std::vector<int> one_each, two_each;
  std::vector<int> packed;  // empty for a single core, which has no half
};

/// None where no core has two hardware threads. On a hybrid machine, the fastest kind of core that has them;
/// an odd core is left out, so that half of them is a whole number, and cores for which there may be no more
/// threads.
[[nodiscard]] std::optional<HyperThreadingPlacements> hyper_threading_placements(const Topology& topology);

/// Processors as `pin` takes them: "0,2,4-7".
[[nodiscard]] std::string processor_list(const std::vector<int>& processors);

}  // namespace raysweep
