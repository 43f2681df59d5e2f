#include "experiments/peers/embree_team.h"

#include <dlfcn.h>
#include <fmt/format.h>

#include <filesystem>

#include "experiments/errors.h"

namespace raysweep {

const EmbreeModule& load_embree() {
  const auto folder = std::filesystem::read_symlink("/proc/self/exe").parent_path() / "modules";
  const std::string file = (folder / "raysweep_embree.so").string();
  if (!std::filesystem::exists(file)) {
    throw RequestError(
        fmt::format("there is no Embree to compare with: Embree 3 and TBB (libembree-dev, libtbb-dev) were "
                    "not found when raysweep was configured; there is no {}",
                    file));
  }
  // It stays: TBB keeps threads of its own.
  void* const library = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (!library) throw RequestError(fmt::format("Embree's module is not loadable: {}", dlerror()));
  const auto function = reinterpret_cast<EmbreeModuleFunction>(dlsym(library, embree_module_symbol));
  if (!function) throw RequestError(fmt::format("{} is no raysweep module", file));
  const EmbreeModule* const module = function();
  if (module->layout != embree_layout)
    throw RequestError(fmt::format("{} is of another build than this program; build all targets", file));
  return *module;
}

}  // namespace raysweep
