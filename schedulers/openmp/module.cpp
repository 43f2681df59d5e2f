// The OpenMP family: one worksharing loop a scheduler. Compiled once by g++ for libgomp and once by clang++
// for libomp.
#include "schedulers/module.h"

#include <omp.h>

#include "schedulers/openmp/loop_chunks.h"
#include "schedulers/openmp/team.h"

namespace raysweep {

namespace {

/// schedule(static) deals as many blocks as threads, so the loop runs over blocks: each thread gets the one
/// that it would get of the items, and hands it on in one piece.
class OmpStatic final : public OmpScheduler {
  using OmpScheduler::OmpScheduler;
  void run_team(const ItemSpace& items, const Chunk&, const Work& work) override {
    const auto parts = static_cast<size_t>(threads());
#pragma omp parallel for schedule(static) num_threads(threads())
    for (size_t part = 0; part < parts; ++part) {
      const size_t begin = block_begin(items.count, part, parts),
                   end = block_begin(items.count, part + 1, parts);
      if (begin < end) work(begin, end, omp_get_thread_num());
    }
  }
};

/// schedule(static, chunk): chunks dealt round robin, as a loop over chunks.
class OmpStaticChunk final : public OmpScheduler {
  using OmpScheduler::OmpScheduler;
  void run_team(const ItemSpace& items, const Chunk& chunk, const Work& work) override {
    const size_t size = chunk.size(items, threads());
#pragma omp parallel for schedule(static, 1) num_threads(threads())
    for (size_t begin = 0; begin < items.count; begin += size)
      work(begin, std::min(begin + size, items.count), omp_get_thread_num());
  }
};

/// schedule(dynamic, chunk), as a loop over chunks: one request to the runtime for each, as over items.
class OmpDynamic final : public OmpScheduler {
  using OmpScheduler::OmpScheduler;
  void run_team(const ItemSpace& items, const Chunk& chunk, const Work& work) override {
    const size_t size = chunk.size(items, threads());
#pragma omp parallel for schedule(dynamic, 1) num_threads(threads())
    for (size_t begin = 0; begin < items.count; begin += size)
      work(begin, std::min(begin + size, items.count), omp_get_thread_num());
  }
};

/// schedule(guided, chunk). Only the runtime knows where its chunks end.
class OmpGuided final : public OmpScheduler {
  using OmpScheduler::OmpScheduler;
  void run_team(const ItemSpace& items, const Chunk& chunk, const Work& work) override {
    const auto size = static_cast<long>(chunk.size(items, threads()));
#pragma omp parallel num_threads(threads())
    for_guided_chunks(static_cast<long>(items.count), size, work);
  }
};

/// schedule(auto): the runtime's choice, and it knows where its chunks end.
class OmpAuto final : public OmpScheduler {
  using OmpScheduler::OmpScheduler;
  void run_team(const ItemSpace& items, const Chunk&, const Work& work) override {
    omp_set_schedule(omp_sched_auto, 0);
#pragma omp parallel num_threads(threads())
    for_runtime_chunks(static_cast<long>(items.count), work);
  }
};

/// taskloop over chunks, a task for each. Over items, grainsize(chunk) would let the runtime make tasks of up
/// to twice as many items as asked for.
/// libgomp 12 runs a taskloop of more than 64 tasks a thread by the thread that meets it, alone; the record
/// then shows one worker. Ask for larger chunks, such as 32/thread.
class OmpTaskloop final : public OmpScheduler {
  using OmpScheduler::OmpScheduler;
  void run_team(const ItemSpace& items, const Chunk& chunk, const Work& work) override {
    const size_t size = chunk.size(items, threads());
#pragma omp parallel num_threads(threads())
#pragma omp single nowait
#pragma omp taskloop grainsize(1)
    for (size_t begin = 0; begin < items.count; begin += size)
      work(begin, std::min(begin + size, items.count), omp_get_thread_num());
  }
};

}  // namespace

extern "C" const Module* raysweep_module() {
  static const Module module{shared_layout,
                             {{"omp_static", make_omp<OmpStatic>},
                              {"omp_static_chunk", make_omp<OmpStaticChunk>},
                              {"omp_dynamic", make_omp<OmpDynamic>},
                              {"omp_guided", make_omp<OmpGuided>},
                              {"omp_auto", make_omp<OmpAuto>},
                              {"omp_taskloop", make_omp<OmpTaskloop>}},
                             "OpenMP " + std::to_string(_OPENMP) + " by " + compiler(),
                             library_of(runtime_entry())};
  return &module;
}

}  // namespace raysweep
