// Kernels as a module compiles them. What reads this is compiled with RAYSWEEP_KERNELS_*: NAME of the
// instruction set, "baseline" where there is no more than in the program; LANES whether kernels of many lanes
// are wanted, and CONTRACTED whether the flags allow a·b + c to become one operation.
#pragma once

#include <string>

#include "experiments/intersection/compiler_name.h"
#include "experiments/intersection/scalar_pass.h"

#if RAYSWEEP_KERNELS_LANES
#include "experiments/intersection/lane_passes.h"
#endif

namespace raysweep {

namespace module_kernels {

template <class Pass, class T>
std::unique_ptr<KernelPass> prepare(const Workload<T>& work) {
  return std::make_unique<Pass>(work);
}

/// With all but its shape and its function.
template <class Method, Variant variant, class T>
Kernel<T> blank(const std::string& change) {
  return {.method = Method::name,
          .change = change,
          .variant = variant,
          .layout = "aos",
          .contraction = RAYSWEEP_KERNELS_CONTRACTED ? "on" : "off",
          .compiler = compiler_name,
          .isa = RAYSWEEP_KERNELS_NAME,
          .bytes = sizeof(TriangleFor<Method, variant, T>),
          .prepare = nullptr};
}

template <class Method, Variant variant, class T>
Kernel<T> of_one(const std::string& change) {
  Kernel<T> kernel = blank<Method, variant, T>(change);
  kernel.prepare = prepare<ScalarPass<Method, variant, T>, T>;
  return kernel;
}

#if RAYSWEEP_KERNELS_LANES
#if HWY_TARGET != HWY_STATIC_TARGET
#error "the flags must choose the instruction set"
#endif

/// `width` rays at once.
template <class Method, Variant variant, class T, int width>
Kernel<T> of_packets() {
  Kernel<T> kernel = blank<Method, variant, T>("rays=" + std::to_string(width));
  kernel.rays = width;
  kernel.prepare = prepare<PacketPass<Method, variant, T, width>, T>;
  return kernel;
}

/// `width` triangles at once.
template <class Method, Variant variant, class T, int width, Layout layout>
Kernel<T> of_blocks() {
  Kernel<T> kernel = blank<Method, variant, T>("triangles=" + std::to_string(width));
  if (layout != Layout::blocks) kernel.change += ",layout=" + std::string(name_of(layout));
  kernel.triangles = width;
  kernel.layout = name_of(layout);
  kernel.prepare = prepare<BlockPass<Method, variant, T, width, layout>, T>;
  return kernel;
}
#endif

}  // namespace module_kernels

}  // namespace raysweep
