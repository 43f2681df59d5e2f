#include "results/statistics/random.h"

#include <bit>

namespace raysweep {

size_t Random::index(size_t count) {
  if (count == 1) return 0;
  // As many bits as the largest index has; numbers beyond it are drawn again, less than once on average.
  const int unused = 64 - static_cast<int>(std::bit_width(count - 1));
  for (;;) {
    const uint64_t number = bits_() >> unused;
    if (number < count) return number;
  }
}

}  // namespace raysweep
