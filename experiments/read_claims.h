// [[claim]], [published] and [quick] of any config, and the question in its first line.
#pragma once

#include <toml++/toml.h>

#include <string>
#include <vector>

#include "experiments/claims_config.h"
#include "experiments/toml_reader.h"

namespace raysweep {

/// A config as it was asked for.
struct ConfigRequest {
  const std::string& text;  // as it was written
  const std::vector<std::string>& overrides;
};

/// Collects what is wrong in `reader`. A published table is looked
/// for in results/ of the sources, then beside the config.
[[nodiscard]] ClaimsConfig read_claims(TomlReader& reader, const toml::table& root, ConfigRequest request,
                                       ClaimScope scope);

/// What [quick] changes: none where there is no such section, or nothing readable in it.
[[nodiscard]] std::vector<std::string> quick_overrides(const toml::table& root);

}  // namespace raysweep
