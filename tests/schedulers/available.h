// The schedulers that can be made here, for tests over the registry.
#pragma once

#include <string>
#include <vector>

#include "schedulers/registry.h"

namespace raysweep {

inline std::vector<std::string> available_schedulers() {
  std::vector<std::string> names;
  for (const SchedulerInfo& info : all_schedulers()) {
    if (why_unavailable(info.family).empty()) names.emplace_back(info.name);
  }
  return names;
}

}  // namespace raysweep
