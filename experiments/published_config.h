// [published] of a config: which table, and what its numbers are of.
#pragma once

#include <optional>
#include <string>

#include "experiments/claim_values.h"

namespace raysweep {

/// None where there is no such section, or something is wrong with it.
[[nodiscard]] std::optional<PublishedTable> read_published_table(TomlReader& reader, ClaimValues& values,
                                                                 const toml::table& root,
                                                                 const ClaimScope& scope);

}  // namespace raysweep
