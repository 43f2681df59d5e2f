#include "schedulers/topology.h"

#include <fmt/format.h>
#include <hwloc.h>

#include <algorithm>
#include <array>
#include <map>
#include <memory>
#include <set>

namespace raysweep {

namespace {

using Handle = std::unique_ptr<hwloc_topology, decltype(&hwloc_topology_destroy)>;

Handle new_handle() {
  hwloc_topology_t raw = nullptr;
  if (hwloc_topology_init(&raw) != 0) throw TopologyError("hwloc cannot be initialised");
  return {raw, hwloc_topology_destroy};
}

void outline(hwloc_topology_t topology, hwloc_obj_t object, int indent, std::vector<std::string>& lines) {
  std::array<char, 64> type{}, attributes{};
  hwloc_obj_type_snprintf(type.data(), type.size(), object, 0);
  hwloc_obj_attr_snprintf(attributes.data(), attributes.size(), object, ", ", 0);
  std::string line(static_cast<size_t>(2 * indent), ' ');
  line += type.data();
  if (object->os_index != HWLOC_UNKNOWN_INDEX) line += fmt::format(" {}", object->os_index);
  if (attributes[0] != '\0') line += fmt::format(" ({})", attributes.data());
  lines.push_back(line);
  for (hwloc_obj_t memory = object->memory_first_child; memory; memory = memory->next_sibling)
    outline(topology, memory, indent + 1, lines);
  for (unsigned i = 0; i < object->arity; ++i) outline(topology, object->children[i], indent + 1, lines);
}

std::string cpu_model(hwloc_topology_t topology) {
  const hwloc_obj_t package = hwloc_get_obj_by_type(topology, HWLOC_OBJ_PACKAGE, 0);
  const char* const name = package ? hwloc_obj_get_info_by_name(package, "CPUModel") : nullptr;
  return name ? name : "unknown processor";
}

/// The ancestor of that type by its number; −1 if there is none.
int number_of(hwloc_topology_t topology, hwloc_obj_type_t type, hwloc_obj_t pu) {
  const hwloc_obj_t object = hwloc_get_ancestor_obj_by_type(topology, type, pu);
  return object ? static_cast<int>(object->logical_index) : -1;
}

/// The last level of cache above `pu`: levels differ between kinds of cores, so the object tells it apart.
hwloc_obj_t last_cache(hwloc_obj_t pu) {
  hwloc_obj_t last = nullptr;
  for (hwloc_obj_t above = pu->parent; above; above = above->parent) {
    if (hwloc_obj_type_is_dcache(above->type)) last = above;
  }
  return last;
}

int speed_of(hwloc_topology_t topology, hwloc_obj_t pu) {
  const int kind = hwloc_cpukinds_get_by_cpuset(topology, pu->cpuset, 0);
  int efficiency = -1;  // hwloc's rank, the most power-hungry highest; −1: it cannot tell
  if (kind >= 0)
    hwloc_cpukinds_get_info(topology, static_cast<unsigned>(kind), nullptr, &efficiency, nullptr, nullptr, 0);
  return std::max(0, efficiency);
}

}  // namespace

std::vector<int> Topology::processor_numbers() const {
  std::vector<int> numbers;
  for (const HardwareThread& t : hardware_threads) numbers.push_back(t.processor);
  std::ranges::sort(numbers);
  return numbers;
}

int Topology::cores() const {
  std::set<int> cores;
  for (const HardwareThread& t : hardware_threads) cores.insert(t.core);
  return static_cast<int>(cores.size());
}

int Topology::packages() const {
  std::set<int> packages;
  for (const HardwareThread& t : hardware_threads) packages.insert(t.package);
  return static_cast<int>(packages.size());
}

const HardwareThread* Topology::find(int processor) const {
  const auto found = std::ranges::find(hardware_threads, processor, &HardwareThread::processor);
  return found == hardware_threads.end() ? nullptr : &*found;
}

Topology read_topology(hwloc_topology* loaded) {
  Topology topology;
  topology.cpu = cpu_model(loaded);
  outline(loaded, hwloc_get_root_obj(loaded), 0, topology.outline);
  std::map<int, int> siblings;
  std::map<hwloc_obj_t, int> caches;
  for (hwloc_obj_t pu = nullptr; (pu = hwloc_get_next_obj_by_type(loaded, HWLOC_OBJ_PU, pu));) {
    const int found_core = number_of(loaded, HWLOC_OBJ_CORE, pu);
    const int core = found_core >= 0 ? found_core  // some virtual machines show no cores: each PU is one
                                     : static_cast<int>(pu->logical_index);
    const hwloc_obj_t cache = last_cache(pu);
    const int cache_number =
        cache ? caches.emplace(cache, static_cast<int>(caches.size())).first->second : -1;
    topology.hardware_threads.push_back({static_cast<int>(pu->os_index), core, siblings[core]++,
                                         std::max(0, number_of(loaded, HWLOC_OBJ_PACKAGE, pu)), cache_number,
                                         speed_of(loaded, pu)});
  }
  return topology;
}

Topology this_topology() {
  const Handle handle = new_handle();
  if (hwloc_topology_load(handle.get()) != 0)
    throw TopologyError("hwloc cannot read this machine's topology");
  if (hwloc_topology_is_thissystem(handle.get())) {
    // What the affinity mask leaves out is not ours to count.
    const std::unique_ptr<hwloc_bitmap_s, decltype(&hwloc_bitmap_free)> allowed(hwloc_bitmap_alloc(),
                                                                                hwloc_bitmap_free);
    if (hwloc_get_cpubind(handle.get(), allowed.get(), HWLOC_CPUBIND_PROCESS) == 0)
      hwloc_topology_restrict(handle.get(), allowed.get(), 0);
  }
  return read_topology(handle.get());
}

Topology synthetic_topology(const std::string& description) {
  const Handle handle = new_handle();
  if (hwloc_topology_set_synthetic(handle.get(), description.c_str()) != 0 ||
      hwloc_topology_load(handle.get()) != 0) {
    throw TopologyError(
        fmt::format("\"{}\" describes no machine: hwloc knows such as \"pack:1 core:6 pu:2\"", description));
  }
  return read_topology(handle.get());
}

}  // namespace raysweep
