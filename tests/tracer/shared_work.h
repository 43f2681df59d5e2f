// Ways to share work, which must not change what comes out.
#pragma once

#include <atomic>
#include <thread>
#include <vector>

#include "tracer/for_each.h"

namespace raysweep {

inline void backwards(size_t count, const std::function<void(size_t)>& body) {
  while (count-- > 0) body(count);
}

inline void by_threads(size_t count, const std::function<void(size_t)>& body) {
  std::atomic<size_t> next{0};
  std::vector<std::jthread> threads;
  for (int i = 0; i < 3; ++i) {
    threads.emplace_back([&] {
      for (size_t k = next++; k < count; k = next++) body(k);
    });
  }
}

}  // namespace raysweep
