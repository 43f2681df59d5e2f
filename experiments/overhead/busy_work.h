// Work of a known length that touches no memory but one word of its thread's own.
#pragma once

#include <cstddef>
#include <cstdint>

#include "schedulers/item_space.h"

namespace raysweep {

/// So many multiply-adds, each dependent on the one before, four cycles or some 1 ns; the first one on the
/// last of the thread's call before, so that the processor cannot do two calls at once, which it would do
/// with short ones. Never removed, never inlined.
void busy_work(std::uint64_t iterations) noexcept;

/// What one iteration takes on the calling thread now, in nanoseconds: the median over 200 batches of 10⁵,
/// some 20 ms together. A batch is far longer than its call and a clock reading, far shorter than a time
/// slice.
[[nodiscard]] double nanoseconds_of_an_iteration();

/// A body whose items are so many iterations each.
[[nodiscard]] Body busy_items(std::uint64_t iterations);

}  // namespace raysweep
