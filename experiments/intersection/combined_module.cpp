// The tracer's own methods with several factors changed at once: a module of one ray and triangle at a time,
// and one in lanes.
#include "experiments/intersection/combined_kernels.h"
#include "experiments/intersection/module_entry.h"
#include "tracer/intersect/all.h"

namespace raysweep {

template <class T>
void add_kernels(std::vector<Kernel<T>>& kernels) {
  for_each_method([&]<class Method>(Method) { add_combined<Method>(kernels); });
}

}  // namespace raysweep
