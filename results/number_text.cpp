#include "results/number_text.h"

#include <fmt/format.h>

#include <cmath>

namespace raysweep {

std::string significant(double value) {
  const double size = std::abs(value);
  const int decimals = size >= 1000 ? 0 : size >= 100 ? 1 : size >= 10 ? 2 : 3;
  return fmt::format("{:.{}f}", value, decimals);
}

}  // namespace raysweep
