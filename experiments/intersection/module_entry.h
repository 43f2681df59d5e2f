// What the loader of a module asks for. Read by one source of each module, which defines `add_kernels`.
#pragma once

#include "experiments/intersection/kernel_module.h"

namespace raysweep {

/// Adds all that the module has.
template <class T>
void add_kernels(std::vector<Kernel<T>>& kernels);

template <class T>
const std::vector<Kernel<T>>& kernels_once() {
  static const std::vector<Kernel<T>> list = [] {
    std::vector<Kernel<T>> all;
    add_kernels(all);
    return all;
  }();
  return list;
}

extern "C" [[gnu::visibility("default")]] const KernelModule* raysweep_kernel_module() {
  static const KernelModule module{kernel_layout, &kernels_once<float>(), &kernels_once<double>()};
  return &module;
}

}  // namespace raysweep
