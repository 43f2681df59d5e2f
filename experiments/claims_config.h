// What any config says of claims, and what claims can be about.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "results/claims/claim_sheet.h"

namespace raysweep {

/// What claims about an experiment can name.
struct ClaimScope {
  std::vector<std::string> quantities;  // the first is meant where a claim names none
  /// Factors, and the values that the sweep gives them; none listed: whatever they may be.
  std::map<std::string, std::vector<std::string>> factors;
  /// Whether the sweep is as its file has it. --set may leave out what a claim is about; then it cannot be
  /// judged, which is no error.
  bool is_whole = true;
};

struct ClaimsConfig {
  ClaimSheet sheet;
  std::vector<std::string> quick;  // what a quick run changes: KEY=VALUE, as --set does
};

}  // namespace raysweep
