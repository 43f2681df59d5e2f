#include "results/random.h"

namespace raysweep {

size_t Random::index(size_t count) {
  // Draws from the last, incomplete block of `count` numbers are drawn again.
  const uint64_t blocks = std::mt19937_64::max() / count;
  for (;;) {
    const uint64_t block_index = bits_() / blocks;
    if (block_index < count) return block_index;
  }
}

}  // namespace raysweep
