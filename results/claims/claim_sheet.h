// What a run is to be judged by, as plan.json keeps it.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "results/claims/claim.h"
#include "results/claims/published_table.h"

namespace raysweep {

struct ClaimSheet {
  std::string question;  // that the experiment answers; may be empty
  std::string command;   // that makes the run
  std::vector<Claim> claims;
  std::optional<PublishedTable> published;
};

/// Adds "question", "command", "claims" and "published" to a plan, each where there is any.
void add_to_plan(nlohmann::json& plan, const ClaimSheet& sheet);

/// Of a plan; empty of one that has none. Throws nlohmann's exceptions, and RecordError, for what is none.
[[nodiscard]] ClaimSheet claim_sheet_of(const nlohmann::json& plan);

}  // namespace raysweep
