// Claims judged: first on what was printed, then on what was measured, by the same code.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "results/claims/claim.h"
#include "results/claims/claim_sheet.h"

namespace raysweep {

enum class ClaimVerdict { holds, fails, untold };

/// The rule's number of one group.
struct GroupJudgement {
  Factors group;
  std::optional<double> value;               // none: see `problem`
  std::optional<Estimate::Bounds> interval;  // 95 % of ours; of what is printed, what its digits leave open
  std::optional<double> low, high;           // expected; none: no bound
  bool low_open = false, high_open = false;  // whether the bound itself is outside
  std::optional<bool> holds;                 // none: undecided
  std::string problem;                       // why, as a part of a sentence
};

/// A claim on one set of numbers.
struct SideJudgement {
  ClaimVerdict verdict = ClaimVerdict::untold;
  bool is_undecided = false;  // of `untold`: there are numbers, but they do not tell
  std::string sentence;       // what was found, and why it is the verdict
  std::vector<GroupJudgement> groups;
};

struct ClaimJudgement {
  Claim claim;
  SideJudgement published, ours;

  /// "holds in the source", "contradicted by its own table", "not in a table", "undecided by its digits"
  [[nodiscard]] std::string published_verdict() const;
  /// "reproduced", "not reproduced", "cannot be tested here"
  [[nodiscard]] std::string our_verdict() const;
};

/// A claim on numbers of one machine. Intervals of what was measured come from rounds drawn together, so that
/// what disturbs all cells of a round cancels; of what was printed, from half a unit of each last digit.
[[nodiscard]] SideJudgement judge(const Claim& claim, const std::vector<Observation>& observations,
                                  const MachineCounts& machine);

/// All claims of a sheet, in their order.
[[nodiscard]] std::vector<ClaimJudgement> judge_all(const ClaimSheet& sheet, const Observations& ours,
                                                    const MachineCounts& machine);

}  // namespace raysweep
