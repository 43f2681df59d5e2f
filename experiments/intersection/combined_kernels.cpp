// All that the factors of a method can be at once. Compiled for one method at a time, RAYSWEEP_METHOD, since
// there are hundreds, and as module_kernels.h says.
#include "experiments/intersection/combined_kernels.h"

#include "experiments/intersection/module_kernels.h"
#include "experiments/intersection/variant_names.h"
#include "tracer/intersect/study.h"

namespace raysweep {

namespace {

#if RAYSWEEP_KERNELS_LANES
/// Lanes have what they need computed ahead: a factor less.
template <class Method, Variant variant, class T>
constexpr bool has_lanes = applies<Method, Lanes<T, 8, Axes::shared>>(variant) && has_constants<Method> ==
                                                                                      (variant.data ==
                                                                                       Data::precomputed);

/// Eight rays and eight triangles at once. The base variant is the star's.
template <class Method, Variant variant, class T>
void add_lanes(std::vector<Kernel<T>>& kernels) {
  constexpr Variant base = base_variant<Method>();
  if constexpr (has_lanes<Method, variant, T> && variant != base) {
    kernels.push_back(module_kernels::of_packets<Method, variant, T, 8>());
    kernels.push_back(module_kernels::of_blocks<Method, variant, T, 8, Layout::blocks>());
    for (size_t last = kernels.size() - 2; last < kernels.size(); ++last)
      kernels[last].change.append(",").append(change_of(base, variant));
  }
}
#else
/// What differs in one factor is the star's.
template <class Method, Variant variant, class T>
void add_one(std::vector<Kernel<T>>& kernels) {
  constexpr Variant base = base_variant<Method>();
  if constexpr (change_count(base, variant) > 1)
    kernels.push_back(module_kernels::of_one<Method, variant, T>(change_of(base, variant)));
}
#endif

template <class Method, class T>
std::vector<Kernel<T>> combined() {
  std::vector<Kernel<T>> kernels;
  for_each_combination<Method, T>([&]<Variant variant>() {
#if RAYSWEEP_KERNELS_LANES
    add_lanes<Method, variant>(kernels);
#else
    add_one<Method, variant>(kernels);
#endif
  });
  for (Kernel<T>& kernel : kernels) kernel.combines = true;
  return kernels;
}

template <class T>
void append(std::vector<Kernel<T>>& all, std::vector<Kernel<T>> some) {
  for (Kernel<T>& kernel : some) all.push_back(std::move(kernel));
}

}  // namespace

template <>
void add_combined<RAYSWEEP_METHOD>(std::vector<Kernel<float>>& kernels) {
  append(kernels, combined<RAYSWEEP_METHOD, float>());
}
template <>
void add_combined<RAYSWEEP_METHOD>(std::vector<Kernel<double>>& kernels) {
  append(kernels, combined<RAYSWEEP_METHOD, double>());
}

}  // namespace raysweep
