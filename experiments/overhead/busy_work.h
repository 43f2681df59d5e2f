// Work of a known length that touches no memory.
#pragma once

#include <cstddef>
#include <cstdint>

#include "schedulers/item_space.h"

namespace raysweep {

/// So many multiply-adds, each dependent on the one before, four cycles or some 1 ns. Never removed, never
/// inlined. It begins when all before it is done, and ends before anything after it begins: a processor that
/// looks hundreds of instructions ahead would hide in it what it costs to hand out the next one.
void busy_work(std::uint64_t iterations) noexcept;

/// How long busy work is on one thread, in nanoseconds.
struct WorkSpeed {
  double call = 0;       // of nothing
  double iteration = 0;  // each

  [[nodiscard]] double nanoseconds(double iterations) const { return call + iterations * iteration; }
};

/// That of the calling thread now: medians over 200 batches of some 50 µs, far longer than a clock reading,
/// far shorter than a time slice; some 20 ms together.
[[nodiscard]] WorkSpeed measure_work_speed();

/// A body whose items are so many iterations each.
[[nodiscard]] Body busy_items(std::uint64_t iterations);

}  // namespace raysweep
