// The factors of a record as text: what tables print in columns and captions.
#pragma once

#include <string>
#include <vector>

#include "results/scaling.h"

namespace raysweep {

struct FactorText {
  std::string name;
  std::string (*text)(const Record&);
  bool number;
  std::string usual{};  // captions do not mention this value
};

/// All factors of a cell, in the order of columns.
[[nodiscard]] const std::vector<FactorText>& factor_texts();

/// The factors that `rows` need as columns: those with more than one value, and scheduler and threads in any
/// case. What the mode's name decides alone is left out, and a "-" (the scheduler ignores the factor) is no
/// value of its own.
[[nodiscard]] std::vector<FactorText> varying_factors(const std::vector<CellRow>& rows);

/// The other factors with their one value, for a caption: "scene chair-ball · mode hard · …".
[[nodiscard]] std::string constant_factors(const std::vector<CellRow>& rows,
                                           const std::vector<FactorText>& varying);

}  // namespace raysweep
