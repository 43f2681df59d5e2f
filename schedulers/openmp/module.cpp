// The OpenMP family: one worksharing loop a scheduler.
#include "schedulers/module.h"

#include <omp.h>

#include "schedulers/builtin.h"

namespace raysweep {

namespace {

/// schedule(static) deals as many blocks as threads, so the loop runs over blocks: each thread gets the one
/// that it would get of the items, and hands it on in one piece.
class OmpStatic final : public Scheduler {
 public:
  explicit OmpStatic(int threads) : threads_(threads) {}

 private:
  void run_items(const ItemSpace& items, const Chunk&, const Body& body) override {
    const auto parts = static_cast<size_t>(threads_);
#pragma omp parallel for schedule(static) num_threads(threads_)
    for (size_t part = 0; part < parts; ++part) {
      const size_t begin = block_begin(items.count, part, parts),
                   end = block_begin(items.count, part + 1, parts);
      if (begin < end) body(begin, end, omp_get_thread_num());
    }
  }

  int threads_;
};

/// schedule(dynamic, chunk), as a loop over chunks: one request to the runtime for each, as over items.
class OmpDynamic final : public Scheduler {
 public:
  explicit OmpDynamic(int threads) : threads_(threads) {}

 private:
  void run_items(const ItemSpace& items, const Chunk& chunk, const Body& body) override {
    const size_t size = chunk.size(items.count, threads_);
#pragma omp parallel for schedule(dynamic, 1) num_threads(threads_)
    for (size_t begin = 0; begin < items.count; begin += size) {
      body(begin, std::min(begin + size, items.count), omp_get_thread_num());
    }
  }

  int threads_;
};

/// schedule(guided, chunk). Only the runtime knows where its chunks end, so items are handed on one by one.
class OmpGuided final : public Scheduler {
 public:
  explicit OmpGuided(int threads) : threads_(threads) {}

 private:
  [[nodiscard]] bool calls_by_item() const override { return true; }

  void run_items(const ItemSpace& items, const Chunk& chunk, const Body& body) override {
    const size_t size = chunk.size(items.count, threads_);
#pragma omp parallel for schedule(guided, size) num_threads(threads_)
    for (size_t i = 0; i < items.count; ++i) body(i, i + 1, omp_get_thread_num());
  }

  int threads_;
};

template <class S>
std::unique_ptr<Scheduler> make(int threads) {
  omp_set_dynamic(0);  // the team is as large as asked for, or the record shows it
  return std::make_unique<S>(threads);
}

}  // namespace

extern "C" const Module* raysweep_module() {
  static const Module module{
      {{"omp_static", make<OmpStatic>}, {"omp_dynamic", make<OmpDynamic>}, {"omp_guided", make<OmpGuided>}},
      "OpenMP " + std::to_string(_OPENMP) + ", " +
          library_of(reinterpret_cast<const void*>(&omp_get_thread_num))};
  return &module;
}

}  // namespace raysweep
