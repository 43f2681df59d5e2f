// Advice, as people and as programs read it.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "experiments/advise/advisor.h"
#include "results/tables/table.h"

namespace raysweep {

/// What can be rendered with: predicted and measured errors side by side, times and verdicts.
[[nodiscard]] Table advice_table(const Advice& advice);
/// Every method of the study: the same of errors, and what a test takes alone.
[[nodiscard]] Table study_table(const Advice& advice);
/// What the errors come from: the numbers of the scene's hits.
[[nodiscard]] Table numbers_table(const Advice& advice);

/// One document; infinite bounds are null.
[[nodiscard]] nlohmann::json to_json(const Advice& advice);

}  // namespace raysweep
