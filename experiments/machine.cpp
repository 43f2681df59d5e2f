#include "experiments/machine.h"

#include <fmt/format.h>
#include <hwloc.h>
#include <sys/utsname.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>
#include <sstream>

#include "experiments/errors.h"

namespace raysweep {

namespace {

using Topology = std::unique_ptr<hwloc_topology, decltype(&hwloc_topology_destroy)>;

Topology load_topology() {
  hwloc_topology_t raw = nullptr;
  if (hwloc_topology_init(&raw) != 0) throw WorkError("hwloc cannot be initialised");
  Topology topology(raw, hwloc_topology_destroy);
  if (hwloc_topology_load(raw) != 0) throw WorkError("hwloc cannot read this machine's topology");
  if (hwloc_topology_is_thissystem(raw)) {
    // What the affinity mask leaves out is not ours to count.
    const std::unique_ptr<hwloc_bitmap_s, decltype(&hwloc_bitmap_free)> allowed(hwloc_bitmap_alloc(),
                                                                                hwloc_bitmap_free);
    if (hwloc_get_cpubind(raw, allowed.get(), HWLOC_CPUBIND_PROCESS) == 0)
      hwloc_topology_restrict(raw, allowed.get(), 0);
  }
  return topology;
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
  for (unsigned i = 0; i < object->arity; ++i) outline(topology, object->children[i], indent + 1, lines);
}

std::string cpu_model(hwloc_topology_t topology) {
  const hwloc_obj_t package = hwloc_get_obj_by_type(topology, HWLOC_OBJ_PACKAGE, 0);
  const char* const name = package ? hwloc_obj_get_info_by_name(package, "CPUModel") : nullptr;
  return name ? name : "unknown processor";
}

/// `cpu.max` of this process's control group (version 2), the smallest on the way up.
std::optional<double> cpu_quota() {
  std::ifstream groups("/proc/self/cgroup");
  std::string line;
  std::optional<double> least;
  while (std::getline(groups, line)) {
    if (!line.starts_with("0::")) continue;
    for (std::string path = line.substr(3);; path = path.substr(0, path.rfind('/'))) {
      std::ifstream file("/sys/fs/cgroup" + path + "/cpu.max");
      double quota = 0, period = 0;
      if (file >> quota >> period && period > 0)
        least = std::min(least.value_or(quota / period), quota / period);
      if (path.empty() || path == "/") break;
    }
  }
  return least;
}

double load_average() {
  double load = 0;
  return getloadavg(&load, 1) == 1 ? load : 0;
}

}  // namespace

Machine detect_machine() {
  const Topology topology = load_topology();
  Machine machine;
  std::array<char, 256> host{};
  gethostname(host.data(), host.size() - 1);
  machine.host = host.data();
  utsname system{};
  uname(&system);
  machine.kernel = fmt::format("{} {}", system.sysname, system.release);
#ifdef __clang__
  machine.compiler = "clang " __clang_version__;
#else
  machine.compiler = "gcc " __VERSION__;
#endif
  machine.cpu = cpu_model(topology.get());
  machine.packages = hwloc_get_nbobjs_by_type(topology.get(), HWLOC_OBJ_PACKAGE);
  machine.cores = hwloc_get_nbobjs_by_type(topology.get(), HWLOC_OBJ_CORE);
  machine.pus = hwloc_get_nbobjs_by_type(topology.get(), HWLOC_OBJ_PU);
  if (machine.cores <= 0) machine.cores = machine.pus;  // some virtual machines show no cores
  machine.quota = cpu_quota();
  outline(topology.get(), hwloc_get_root_obj(topology.get()), 0, machine.outline);
  return machine;
}

MachineRecord machine_record(const Machine& machine) {
  return {machine.host, machine.cpu, machine.pus, machine.cores, load_average()};
}

nlohmann::json to_json(const Machine& machine) {
  nlohmann::json json{
      {"host", machine.host},         {"cpu", machine.cpu},           {"kernel", machine.kernel},
      {"compiler", machine.compiler}, {"packages", machine.packages}, {"cores", machine.cores},
      {"pus", machine.pus},           {"load", load_average()},       {"topology", machine.outline}};
  json["quota"] = machine.quota ? nlohmann::json(*machine.quota) : nlohmann::json();
  json["smt"] = machine.pus > machine.cores;
  for (char** variable = environ; *variable; ++variable) {
    const std::string_view entry = *variable;
    for (const std::string_view prefix : {"OMP_", "GOMP_", "KMP_", "TBB_"}) {
      if (entry.starts_with(prefix)) {
        const size_t equals = entry.find('=');
        json["environment"][std::string(entry.substr(0, equals))] = entry.substr(equals + 1);
      }
    }
  }
  return json;
}

}  // namespace raysweep
