#include "experiments/machine.h"

#include <fmt/format.h>
#include <sys/utsname.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>
#include <sstream>

#include "experiments/runtime_variables.h"

namespace raysweep {

namespace {

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
  Machine machine;
  machine.topology = this_topology();
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
  machine.quota = cpu_quota();
  return machine;
}

MachineRecord machine_record(const Machine& machine) {
  const Topology& t = machine.topology;
  return {machine.host, t.cpu, t.processors(), t.cores(), load_average()};
}

nlohmann::json to_json(const Machine& machine) {
  const Topology& t = machine.topology;
  nlohmann::json json{{"host", machine.host},     {"cpu", t.cpu},
                      {"kernel", machine.kernel}, {"compiler", machine.compiler},
                      {"packages", t.packages()}, {"cores", t.cores()},
                      {"pus", t.processors()},    {"load", load_average()},
                      {"topology", t.outline}};
  json["quota"] = machine.quota ? nlohmann::json(*machine.quota) : nlohmann::json();
  json["smt"] = t.has_smt();
  for (char** variable = environ; *variable; ++variable) {
    const std::string_view entry = *variable;
    if (!is_runtime_variable(entry)) continue;
    const size_t equals = entry.find('=');
    json["environment"][std::string(entry.substr(0, equals))] = entry.substr(equals + 1);
  }
  return json;
}

}  // namespace raysweep
