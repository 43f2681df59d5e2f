// The base variants of all methods, compiled once for each module with the flags that it is about.
#include "experiments/intersection/module_entry.h"
#include "experiments/intersection/module_kernels.h"
#include "tracer/intersect/study.h"

namespace raysweep {

namespace {

#if RAYSWEEP_KERNELS_LANES
/// Of double no more than vectors of it hold: it is a factor of its own, and a star changes one at a time.
template <class Method, Variant base, class T>
void add_lanes(std::vector<Kernel<T>>& kernels) {
  using module_kernels::of_blocks, module_kernels::of_packets;
  if constexpr (applies<Method, Lanes<T, 4, Axes::shared>>(base)) {
    kernels.push_back(of_packets<Method, base, T, 4>());
    kernels.push_back(of_packets<Method, base, T, 8>());
    kernels.push_back(of_blocks<Method, base, T, 4, Layout::blocks>());
    kernels.push_back(of_blocks<Method, base, T, 8, Layout::blocks>());
    if constexpr (std::is_same_v<T, float>) {
      kernels.push_back(of_packets<Method, base, T, 16>());
      kernels.push_back(of_blocks<Method, base, T, 16, Layout::blocks>());
      kernels.push_back(of_blocks<Method, base, T, 8, Layout::soa>());
      kernels.push_back(of_blocks<Method, base, T, 8, Layout::aos>());
    }
  }
}
#endif

}  // namespace

template <class T>
void add_kernels(std::vector<Kernel<T>>& kernels) {
  for_each_study_method([&]<class Method>(Method) {
    constexpr Variant base = base_variant<Method>();
    kernels.push_back(module_kernels::of_one<Method, base, T>(""));
#if RAYSWEEP_KERNELS_LANES
    add_lanes<Method, base>(kernels);
#endif
  });
}

}  // namespace raysweep
