#include "experiments/intersection/kernel.h"

#include <fmt/format.h>

#include <algorithm>

#include "experiments/intersection/compiler_name.h"
#include "experiments/intersection/kernel_modules.h"
#include "experiments/intersection/scalar_pass.h"
#include "experiments/intersection/subjects.h"
#include "tracer/intersect/study.h"

namespace raysweep {

namespace {

template <class Method, Variant variant, class T, Layout layout>
Kernel<T> own_kernel(const std::string& change) {
  return {.method = Method::name,
          .change = change,
          .variant = variant,
          .layout = name_of(layout),
          .compiler = compiler_name,
          .isa = "baseline",
          .bytes = sizeof(TriangleFor<Method, variant, T>),
          .prepare = [](const Workload<T>& work) -> std::unique_ptr<KernelPass> {
            return std::make_unique<ScalarPass<Method, variant, T, layout>>(work);
          }};
}

template <class Method, class T, Layout layout>
void add_layout(std::vector<Kernel<T>>& kernels) {
  constexpr Variant base = base_variant<Method>();
  kernels.push_back(own_kernel<Method, base, T, layout>(fmt::format("layout={}", name_of(layout))));
}

/// The program's own.
template <class T>
std::vector<Kernel<T>> own_kernels() {
  std::vector<Kernel<T>> kernels;
  for_each_study_method([&]<class Method>(Method) {
    for_each_variant<Method, T>([&]<Variant variant>() {
      kernels.push_back(
          own_kernel<Method, variant, T, Layout::aos>(change_of(base_variant<Method>(), variant)));
    });
    add_layout<Method, T, Layout::soa>(kernels);
    add_layout<Method, T, Layout::blocks>(kernels);
  });
  return kernels;
}

/// Kernels of a module say of themselves how many rays and triangles they take, and what of the formula has
/// changed; what the module is about is added here. Lanes of the best instruction set are the usual ones, so
/// that it is no change.
std::string full_change(const std::string& shape, const std::string& about, bool is_usual) {
  if (is_usual && !shape.empty()) return shape;
  return shape.empty() ? about : shape + "," + about;
}

template <class T>
const std::vector<Kernel<T>>& kernels_in(const KernelModule& module) {
  if constexpr (std::is_same_v<T, float>) {
    return *module.of_float;
  } else {
    return *module.of_double;
  }
}

template <class T>
void add_module(std::vector<Kernel<T>>& kernels, std::string_view name) {
  if (!why_no_kernels(name).empty()) return;
  for (Kernel<T> kernel : kernels_in<T>(load_kernels(name))) {
    const std::string about = name == "contracted"       ? "contraction=on"
                              : name == "other_compiler" ? "compiler=other"
                                                         : fmt::format("isa={}", kernel.isa);
    kernel.change = full_change(kernel.change, about, kernel.isa == best_lanes() || name == "combined");
    kernels.push_back(std::move(kernel));
  }
}

template <class T>
std::vector<Kernel<T>> list_kernels() {
  std::vector<Kernel<T>> kernels = own_kernels<T>();
  for (const KernelModuleInfo& module : all_kernel_modules()) add_module(kernels, module.name);
  const auto& names = study_method_names();
  std::ranges::stable_sort(kernels, {}, [&](const Kernel<T>& kernel) {
    return std::ranges::find(names, kernel.method) - names.begin();
  });
  return kernels;
}

}  // namespace

template <class T>
const std::vector<Kernel<T>>& all_kernels() {
  static const std::vector<Kernel<T>> kernels = list_kernels<T>();
  return kernels;
}
template const std::vector<Kernel<float>>& all_kernels();
template const std::vector<Kernel<double>>& all_kernels();

}  // namespace raysweep
