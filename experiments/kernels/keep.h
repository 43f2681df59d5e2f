// What benchmark::DoNotOptimize does, which kernels need where Google Benchmark is missing, too.
#pragma once

namespace raysweep {

/// Compilers must have `value` in memory here, and may not take for granted what memory holds from here on.
template <class T>
inline void keep(const T& value) {
  asm volatile("" : : "r"(&value) : "memory");
}

}  // namespace raysweep
