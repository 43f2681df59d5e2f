// A claim of a paper, or ours, as a rule that numbers keep or break.
#pragma once

#include <array>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "results/claims/observation.h"

namespace raysweep {

/// What is asked of the values of a group, v; each comes to one number.
enum class Rule {
  ratio,    // v(of)/v(to)
  argmax,   // the best v of those expected by the best of the others
  argmin,   // likewise, the smallest: the best of the others by the best of those expected
  plateau,  // the largest v by the smallest
  step,     // v(at) by the v before it
  linear,   // the largest residual of a line of least squares, as a share of what was measured
  order,    // the smallest ratio of neighbours, in the order expected
  value,    // v itself
};

inline constexpr std::array<std::string_view, 8> rule_names{"ratio", "argmax", "argmin", "plateau",
                                                            "step",  "linear", "order",  "value"};

[[nodiscard]] constexpr std::string_view name_of(Rule rule) { return rule_names[static_cast<size_t>(rule)]; }

/// What the rule's number must lie in. Bounds are formulas of the machine; empty: none.
struct ExpectedRange {
  std::string low, high;
  bool low_open = false, high_open = false;  // whether the bound itself is outside

  friend bool operator==(const ExpectedRange&, const ExpectedRange&) = default;
};

/// Allowed values of factors: any of them.
using Selector = std::map<std::string, std::vector<std::string>>;

/// Neither: what a source says that no number tells.
enum class AppliesTo { both, published, ours, neither };
inline constexpr std::array<std::string_view, 4> applies_to_names{"both", "published", "ours", "neither"};

/// Values of factors may be formulas of the machine: threads = "2*pus".
struct Claim {
  std::string id, text, source;
  Rule rule = Rule::ratio;
  std::string quantity;
  Selector where;                            // only these observations
  std::vector<std::string> for_each;         // factors whose combinations are judged one by one
  bool has_for_each = false;                 // else those that vary and that the rule does not name
  Factors relative_to;                       // v is divided by that of the observation that differs in these
  Factors of, to;                            // of ratio
  std::string key;                           // of all but ratio and value
  std::vector<std::string> expected_values;  // of argmax, argmin and order
  std::map<std::string, ExpectedRange> expect;  // of the others; by the group's value, or "" for all
  std::vector<std::string> over;                // of plateau and linear: the ends of a range of the key
  std::vector<std::string> values;              // of plateau and linear: these values of the key
  std::string at, from;                         // of step
  bool inverse = false, intercept = false;      // of linear: 1/v; whether the line may miss the origin
  bool smallest_first = false;                  // of order
  double within = 0;                            // of argmax, argmin and order: as good as the best
  std::string holds = "all";                    // "all", "any", "most", or a share of the groups
  std::string applies_when;                     // a formula; empty: always
  AppliesTo applies_to = AppliesTo::both;
  std::string why;  // why ours differ, or hold

  friend bool operator==(const Claim&, const Claim&) = default;
};

}  // namespace raysweep
