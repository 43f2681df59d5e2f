// Comparisons as people read them.
#pragma once

#include <optional>
#include <string>

#include "results/comparison.h"

namespace raysweep {

/// "4.2 % [3.1, 5.4]": how much a change adds or takes, without its sign.
[[nodiscard]] std::string amount(const Change& change);

/// "+4.2 %" or "−4.1 %", of a ratio.
[[nodiscard]] std::string signed_percent(double ratio);

/// "−4.1 % [−5.0, −3.2]"
[[nodiscard]] std::string signed_amount(const Change& change);

/// For a cell of a table: "faster by 4.2 % [3.1, 5.4]", "no difference shown", "too few launches";
/// with "(noise floor unknown)" where it is.
[[nodiscard]] std::string in_words(const std::optional<Change>& change, const NoiseFloor& floor);

/// One whole sentence: "omp_dynamic is faster than omp_static by 4.2 % [3.1, 5.4]", "no difference shown:
/// −0.3 % [−1.2, +0.6], noise floor 0.9 %", and so on; where the floor is not known it says so.
[[nodiscard]] std::string in_a_sentence(const std::string& name, const std::string& base_name,
                                        const std::optional<Change>& change, const NoiseFloor& floor);

}  // namespace raysweep
