// A rule put to one group of observations: which of them it needs, and what number they come to.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "results/claims/claim.h"
#include "results/claims/groups.h"

namespace raysweep {

struct GroupQuestion {
  ObservationList needed;
  /// Of their values, in that order.
  std::function<double(const std::vector<double>&)> statistic;
  bool is_absent = false;  // there are no such observations in this group
  std::string problem;     // why it cannot be asked, as a part of a sentence; empty if it can
};

/// What values are relative to: observations of the claim's quantity, whether `where` allows them or not.
struct Bases {
  ObservationList list;
  std::vector<std::string> telling;  // factors in which a value and its base agree
};

[[nodiscard]] Bases bases_of(const Claim& claim, ObservationList all);

[[nodiscard]] GroupQuestion ask(const Claim& claim, const ObservationGroup& group, const Bases& bases,
                                const MachineCounts& machine);

}  // namespace raysweep
