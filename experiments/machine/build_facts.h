// What was built, from what, and how.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "experiments/machine/fact.h"

namespace raysweep {

struct BuildFacts {
  std::string compiler;    // "gcc 12.2.0"
  std::string type;        // CMake's: "Release"
  std::string flags;       // of everything of our own
  std::string sanitizers;  // "address,undefined", or empty
  Fact<std::string> commit;
  Fact<bool> changed;  // files of that commit have been changed since
};

/// Of this program, as it was when it was last built.
[[nodiscard]] BuildFacts build_facts();

[[nodiscard]] nlohmann::json to_json(const BuildFacts& facts);

}  // namespace raysweep
