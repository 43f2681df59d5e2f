// Claims and what became of them in words.
#pragma once

#include <string>

#include "results/claims/judge.h"

namespace raysweep {

/// What is compared with what, and what is expected: "fps at threads 12 by that at threads 6, expected 1.2 to
/// 1.3".
[[nodiscard]] std::string rule_sentence(const Claim& claim);

/// "1.25 [1.24, 1.26] (mode low)"; its problem where it has no value.
[[nodiscard]] std::string to_text(const GroupJudgement& group);

/// "1.2 to 1.3", "at least 1", "below 2", as numbers; what every group expects, or the first.
[[nodiscard]] std::string expected_text(const GroupJudgement& group);

/// What was found in the groups, of which there is one at least: each where they are few, else the least and
/// the largest; why there is nothing, where no group has a value.
[[nodiscard]] std::string found_text(const std::vector<GroupJudgement>& groups);

}  // namespace raysweep
