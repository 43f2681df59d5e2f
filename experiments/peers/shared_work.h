// Work that a few threads share by a counter: as little of a scheduler as there can be.
#pragma once

#include <cstddef>
#include <functional>

namespace raysweep {

/// Calls `body(i, worker)` once for each `i` below `count`, by `threads` threads, of which the calling one is
/// worker 0. The first error is rethrown when all have stopped; what was not begun by then is left out.
void share_work(int threads, size_t count, const std::function<void(size_t i, size_t worker)>& body);

}  // namespace raysweep
