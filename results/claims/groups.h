// Which observations a claim is about, and which of them are judged together.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "results/claims/claim.h"
#include "results/claims/expression.h"

namespace raysweep {

using ObservationList = std::vector<const Observation*>;

/// Whether an observation has this value of a factor: as it stands, or as a formula of the machine. "-", a
/// factor that its scheduler has no use for, is as good as any value.
[[nodiscard]] bool has_value(const Observation& observation, const std::string& factor,
                             const std::string& value, const MachineCounts& machine);

/// Whether it has all of these.
[[nodiscard]] bool has_values(const Observation& observation, const Factors& values,
                              const MachineCounts& machine);

/// Those that `where` allows.
[[nodiscard]] ObservationList selected(const ObservationList& from, const Selector& where,
                                       const MachineCounts& machine);

/// The factors that, together with those `named`, tell the observations apart: what varies, without what the
/// others decide (a mode decides its width).
[[nodiscard]] std::vector<std::string> telling_factors(const ObservationList& list,
                                                       const std::set<std::string>& named);

struct ObservationGroup {
  Factors factors;  // that its members share
  ObservationList members;
};

/// One group for each combination of values of `factors`, in the order of the observations. An observation
/// with "-" for one of them is in all groups of that factor.
[[nodiscard]] std::vector<ObservationGroup> groups_by(const ObservationList& list,
                                                      const std::vector<std::string>& factors);

/// The factors that the claim's rule names.
[[nodiscard]] std::set<std::string> named_factors(const Claim& claim);

/// "threads 12", "threads = 2*pus".
[[nodiscard]] std::string factor_text(const std::string& name, const std::string& value);

/// "threads 12, mode low"; "all" of none.
[[nodiscard]] std::string to_text(const Factors& factors);

}  // namespace raysweep
