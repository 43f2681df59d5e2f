#include "experiments/intersection/kernel_modules.h"

#include <dlfcn.h>
#include <fmt/format.h>
#include <hwy/targets.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <map>
#include <stdexcept>

namespace raysweep {

namespace {

struct Known {
  KernelModuleInfo info;
  int64_t target;  // Highway's bit of what it needs of the processor; 0: nothing
  bool has_lanes;
};

/// Of lanes the best instruction set first.
constexpr auto known = std::to_array<Known>({
#if HWY_ARCH_X86
  {{"avx512", "lanes, compiled for AVX-512 (F, BW, CD, DQ, VL)"}, HWY_AVX3, true},
      {{"avx2", "lanes, compiled for AVX2 with FMA"}, HWY_AVX2, true},
      {{"sse4", "lanes, compiled for SSE4.2"}, HWY_SSE4, true},
      {{"contracted", "compiled for AVX2 with FMA, a·b + c as one operation"}, HWY_AVX2, false},
#else
  {{"neon", "lanes, compiled for what every processor of this architecture has"}, 0, true},
      {{"contracted", "a·b + c as one operation"}, 0, false},
#endif
      {{"combined", "the tracer's methods with several factors changed at once"}, 0, false},
      {{"combined_lanes", "the same, eight rays or triangles at a time"}, HWY_ARCH_X86 ? HWY_AVX2 : 0, false},
      {{"other_compiler", "by GCC where the program is by Clang, and the other way round"}, 0, false},
});

const Known& known_module(std::string_view name) {
  const auto* const found = std::ranges::find(known, name, [](const Known& k) { return k.info.name; });
  if (found == known.end()) throw std::out_of_range(fmt::format("no kernels are called {}", name));
  return *found;
}

std::filesystem::path file_of(std::string_view name) {
  return std::filesystem::read_symlink("/proc/self/exe").parent_path() / "modules" /
         fmt::format("kernels_{}.so", name);
}

struct Opened {
  const KernelModule* module = nullptr;
  std::string problem;
};

Opened open(const Known& one) {
  const std::string file = file_of(one.info.name).string();
  if (!std::filesystem::exists(file)) return {nullptr, fmt::format("is not built: there is no {}", file)};
  if (one.target != 0 && (hwy::SupportedTargets() & one.target) == 0)
    return {nullptr, "needs instructions that this processor does not have"};
  void* const library = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (!library) return {nullptr, fmt::format("is not loadable: {}", dlerror())};
  const auto function = reinterpret_cast<KernelModuleFunction>(dlsym(library, kernel_module_symbol));
  if (!function) return {nullptr, fmt::format("is no module of kernels: {}", file)};
  const KernelModule* const module = function();
  if (module->layout != kernel_layout)
    return {nullptr, fmt::format("is of another build than this program: {}; build all targets", file)};
  return {module, ""};
}

const Opened& opened(std::string_view name) {
  static const std::map<std::string_view, Opened> all = [] {
    std::map<std::string_view, Opened> modules;
    for (const Known& one : known) modules.emplace(one.info.name, open(one));
    return modules;
  }();
  return all.at(known_module(name).info.name);
}

}  // namespace

std::span<const KernelModuleInfo> all_kernel_modules() {
  static const std::vector<KernelModuleInfo> list = [] {
    std::vector<KernelModuleInfo> infos;
    for (const Known& one : known) infos.push_back(one.info);
    return infos;
  }();
  return list;
}

std::string why_no_kernels(std::string_view name) { return opened(name).problem; }

const KernelModule& load_kernels(std::string_view name) {
  const Opened& module = opened(name);
  if (!module.module) throw std::runtime_error(fmt::format("the module {} {}", name, module.problem));
  return *module.module;
}

std::string_view best_lanes() {
  const auto* const best =
      std::ranges::find_if(known, [](const Known& k) { return k.has_lanes && opened(k.info.name).module; });
  return best == known.end() ? std::string_view() : best->info.name;
}

}  // namespace raysweep
