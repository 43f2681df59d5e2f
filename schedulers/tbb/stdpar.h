// std::execution::par. libstdc++ and libc++ bring it to TBB's threads where TBB's headers are there when it
// is compiled; where they are not, libstdc++ runs it serially and says nothing.
#pragma once

#include <execution>
#include <numeric>

#include "schedulers/module.h"
#include "schedulers/tbb/arena.h"

namespace raysweep {

#if defined(_PSTL_PAR_BACKEND_TBB)

/// std::for_each over the items, inside our arena, which its tasks then share. How items are put together to
/// chunks is the library's choice, and its secret: the log takes neighbouring chunks of one worker for one.
class StdPar final : public TbbScheduler {
  using TbbScheduler::TbbScheduler;
  void run_inside(const ItemSpace& items, const Chunk&, const Work& work) override {
    if (indices_.size() != items.count) {
      indices_.resize(items.count);
      std::iota(indices_.begin(), indices_.end(), size_t{0});
    }
    std::for_each(std::execution::par, indices_.begin(), indices_.end(),
                  [&](size_t i) { work.item(i, this_worker()); });
  }

  std::vector<size_t> indices_;  // kept across runs: filling them is no part of the loop
};

inline ModuleEntry stdpar_entry() { return {"stdpar", make_tbb<StdPar>}; }

#else

inline ModuleEntry stdpar_entry() {
  return {"stdpar", nullptr, "serial in this compiler's library: std::execution::par has no backend in it"};
}

#endif

}  // namespace raysweep
