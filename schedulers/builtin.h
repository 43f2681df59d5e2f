// The schedulers that need no module, each in the file of its name.
#pragma once

#include "schedulers/scheduler.h"

namespace raysweep {

std::unique_ptr<Scheduler> make_serial(int threads);
std::unique_ptr<Scheduler> make_thread_static(int threads);
std::unique_ptr<Scheduler> make_thread_cyclic(int threads);
std::unique_ptr<Scheduler> make_thread_dynamic(int threads);
std::unique_ptr<Scheduler> make_thread_chunks(int threads);
std::unique_ptr<Scheduler> make_thread_spawn(int threads);

/// Where the `part`-th of `parts` near-equal contiguous blocks of `count` items begins.
[[nodiscard]] constexpr size_t block_begin(size_t count, size_t part, size_t parts) {
  return count / parts * part + std::min(part, count % parts);
}

}  // namespace raysweep
