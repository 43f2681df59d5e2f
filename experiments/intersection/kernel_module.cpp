// Compiled once for each module, with the flags that it is about and with RAYSWEEP_KERNELS_*:
// NAME of the instruction set, "baseline" where there is no more than in the program; LANES whether kernels
// of many lanes are wanted, and CONTRACTED whether the flags allow a·b + c to become one operation.
#include "experiments/intersection/kernel_module.h"

#include <array>
#include <string>

#include "experiments/intersection/compiler_name.h"
#include "experiments/intersection/scalar_pass.h"
#include "tracer/intersect/study.h"

#if RAYSWEEP_KERNELS_LANES
#include "experiments/intersection/lane_passes.h"
#endif

namespace raysweep {

namespace {

constexpr std::string_view isa = RAYSWEEP_KERNELS_NAME;
constexpr bool is_contracted = RAYSWEEP_KERNELS_CONTRACTED;

template <class Pass, class T>
std::unique_ptr<KernelPass> prepare(const Workload<T>& work) {
  return std::make_unique<Pass>(work);
}

/// A kernel of the base variant, with all but its shape and its function.
template <class Method, class T>
Kernel<T> blank(const std::string& change) {
  constexpr Variant base = base_variant<Method>();
  return {.method = Method::name,
          .change = change,
          .variant = base,
          .layout = "aos",
          .contraction = is_contracted ? "on" : "off",
          .compiler = compiler_name,
          .isa = isa,
          .bytes = sizeof(TriangleFor<Method, base, T>),
          .prepare = nullptr};
}

template <class Method, class T>
void add_scalar(std::vector<Kernel<T>>& kernels) {
  Kernel<T> kernel = blank<Method, T>("");
  kernel.prepare = prepare<ScalarPass<Method, base_variant<Method>(), T>, T>;
  kernels.push_back(std::move(kernel));
}

#if RAYSWEEP_KERNELS_LANES
#if HWY_TARGET != HWY_STATIC_TARGET
#error "the flags must choose the instruction set"
#endif

template <class Method, class T, int width>
void add_packets(std::vector<Kernel<T>>& kernels) {
  Kernel<T> kernel = blank<Method, T>("rays=" + std::to_string(width));
  kernel.rays = width;
  kernel.prepare = prepare<PacketPass<Method, base_variant<Method>(), T, width>, T>;
  kernels.push_back(std::move(kernel));
}

template <class Method, class T, int width, Layout layout>
void add_blocks(std::vector<Kernel<T>>& kernels) {
  constexpr std::string_view name = layout == Layout::aos ? "aos" : layout == Layout::soa ? "soa" : "blocks";
  Kernel<T> kernel = blank<Method, T>("triangles=" + std::to_string(width));
  if (layout != Layout::blocks) kernel.change += ",layout=" + std::string(name);
  kernel.triangles = width;
  kernel.layout = name;
  kernel.prepare = prepare<BlockPass<Method, base_variant<Method>(), T, width, layout>, T>;
  kernels.push_back(std::move(kernel));
}

/// Of double no more than vectors of it hold: it is a factor of its own, and a star changes one at a time.
template <class Method, class T>
void add_lanes(std::vector<Kernel<T>>& kernels) {
  if constexpr (applies<Method, Lanes<T, 4, Axes::shared>>(base_variant<Method>())) {
    add_packets<Method, T, 4>(kernels);
    add_packets<Method, T, 8>(kernels);
    add_blocks<Method, T, 4, Layout::blocks>(kernels);
    add_blocks<Method, T, 8, Layout::blocks>(kernels);
    if constexpr (std::is_same_v<T, float>) {
      add_packets<Method, T, 16>(kernels);
      add_blocks<Method, T, 16, Layout::blocks>(kernels);
      add_blocks<Method, T, 8, Layout::soa>(kernels);
      add_blocks<Method, T, 8, Layout::aos>(kernels);
    }
  }
}
#endif

template <class T>
const std::vector<Kernel<T>>& kernels() {
  static const std::vector<Kernel<T>> list = [] {
    std::vector<Kernel<T>> all;
    for_each_study_method([&]<class Method>(Method) {
      add_scalar<Method>(all);
#if RAYSWEEP_KERNELS_LANES
      add_lanes<Method>(all);
#endif
    });
    return all;
  }();
  return list;
}

}  // namespace

extern "C" [[gnu::visibility("default")]] const KernelModule* raysweep_kernel_module() {
  static const KernelModule module{kernel_layout, &kernels<float>(), &kernels<double>()};
  return &module;
}

}  // namespace raysweep
