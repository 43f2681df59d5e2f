// The factors of a record as text: what tables print in columns and captions.
#pragma once

#include <string>
#include <vector>

#include "results/record.h"

namespace raysweep {

struct FactorText {
  const char* name;
  std::string (*text)(const Record&);
  bool number;
};

/// All factors of a cell, in the order of columns.
[[nodiscard]] const std::vector<FactorText>& factor_texts();

}  // namespace raysweep
