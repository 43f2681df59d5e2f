// OpenMP's worksharing loops chunk by chunk. The language shows iterations, not chunks; the entry points that
// g++ compiles `#pragma omp for` to show both. libgomp documents them ("The libgomp ABI"), and LLVM's libomp
// has them too, on its own schedules, for programs compiled by g++.
#pragma once

#include <omp.h>

#include "schedulers/work.h"

// NOLINTBEGIN(readability-identifier-naming): the names are the runtimes'
extern "C" {
bool GOMP_loop_guided_start(long begin, long end, long step, long chunk, long* chunk_begin, long* chunk_end);
bool GOMP_loop_guided_next(long* chunk_begin, long* chunk_end);
bool GOMP_loop_runtime_start(long begin, long end, long step, long* chunk_begin, long* chunk_end);
bool GOMP_loop_runtime_next(long* chunk_begin, long* chunk_end);
void GOMP_loop_end_nowait();
void GOMP_parallel(void (*body)(void*), void* data, unsigned threads, unsigned flags);
}
// NOLINTEND(readability-identifier-naming)

namespace raysweep {

/// Hands on the chunks that `begun` and `next` tell of. To be called by every thread of the team, last in its
/// parallel region: the region's end is the only barrier, as where g++ compiles `#pragma omp parallel for`.
template <class Next>
void for_loop_chunks(bool begun, long begin, long end, Next next, const Work& work) {
  for (bool more = begun; more; more = next(&begin, &end))
    work(static_cast<size_t>(begin), static_cast<size_t>(end), omp_get_thread_num());
  GOMP_loop_end_nowait();
}

/// `#pragma omp for schedule(guided, chunk)` over `count` items.
inline void for_guided_chunks(long count, long chunk, const Work& work) {
  long begin = 0, end = 0;
  const bool begun = GOMP_loop_guided_start(0, count, 1, chunk, &begin, &end);
  for_loop_chunks(begun, begin, end, GOMP_loop_guided_next, work);
}

/// `#pragma omp for schedule(runtime)` over `count` items: as omp_set_schedule has said.
inline void for_runtime_chunks(long count, const Work& work) {
  long begin = 0, end = 0;
  const bool begun = GOMP_loop_runtime_start(0, count, 1, &begin, &end);
  for_loop_chunks(begun, begin, end, GOMP_loop_runtime_next, work);
}

/// Some code of the runtime that this process really uses.
inline const void* runtime_entry() { return reinterpret_cast<const void*>(&GOMP_parallel); }

}  // namespace raysweep
