#include "experiments/intersection/case.h"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "experiments/intersection/families.h"

namespace raysweep {

const std::vector<Case>& all_cases() {
  static const std::vector<Case> cases = [] {
    std::vector<Case> all;
    for (const auto family : {mesh_cases, aligned_cases, scale_cases, shape_cases, number_cases, end_cases}) {
      for (Case& one : family()) all.push_back(std::move(one));
    }
    return all;
  }();
  return cases;
}

const Case& case_of(std::string_view id) {
  const auto& all = all_cases();
  const auto found = std::find_if(all.begin(), all.end(), [&](const Case& one) { return one.id == id; });
  if (found == all.end()) throw std::out_of_range("unknown case \"" + std::string(id) + '"');
  return *found;
}

}  // namespace raysweep
