// The schedulers that can be made here, on each of their runtimes, for tests over the registry.
#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "schedulers/registry.h"

namespace raysweep {

struct Tested {
  std::string scheduler, runtime;  // runtime: empty where there is no choice
  [[nodiscard]] std::string name() const { return scheduler + (runtime.empty() ? "" : "_on_" + runtime); }
  friend void PrintTo(const Tested& tested, std::ostream* out) { *out << tested.name(); }
};

inline std::vector<Tested> available_schedulers() {
  std::vector<Tested> list;
  for (const SchedulerInfo& info : all_schedulers()) {
    if (!info.uses_runtime()) {
      if (why_unavailable(info).empty()) list.push_back({std::string(info.name), ""});
      continue;
    }
    for (const RuntimeInfo& runtime : all_runtimes()) {
      const std::string name(runtime.name);
      if (runtime.family == info.family && why_unavailable(info, name).empty())
        list.push_back({std::string(info.name), name});
    }
  }
  return list;
}

}  // namespace raysweep
