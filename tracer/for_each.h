// Work that others may share out: this library knows no threads.
#pragma once

#include <cstddef>
#include <functional>

namespace raysweep {

/// Calls `body(i)` once for each i below `count`, in any order and by any threads, and returns when all are
/// done. What is built with one is the same whatever it does.
using ForEach = std::function<void(size_t count, const std::function<void(size_t)>& body)>;

inline void one_after_the_other(size_t count, const std::function<void(size_t)>& body) {
  for (size_t i = 0; i < count; ++i) body(i);
}

}  // namespace raysweep
