#include "experiments/machine/machine.h"

#include <fmt/format.h>
#include <sys/utsname.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "experiments/machine/build_facts.h"
#include "experiments/machine/cycle_timer.h"
#include "experiments/runtime_variables.h"
#include "schedulers/binding.h"

namespace raysweep {

namespace {

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
  machine.compiler = build_facts().compiler;
  machine.facts = read_machine_facts({allowed_processors(), machine.topology.has_smt()});
  const std::optional<double> quota = machine.facts.quota.value;
  if (quota && std::isfinite(*quota)) machine.quota = quota;
  return machine;
}

MachineRecord machine_record(const Machine& machine) {
  const Topology& t = machine.topology;
  return {machine.host, t.cpu, t.processors(), t.cores(), load_average(), machine.quota};
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
  json["facts"] = to_json(machine.facts);
  json["timer"] = to_json(timer_report());
  json["build"] = to_json(build_facts());
  for (char** variable = environ; *variable; ++variable) {
    const std::string_view entry = *variable;
    if (!is_runtime_variable(entry)) continue;
    const size_t equals = entry.find('=');
    json["environment"][std::string(entry.substr(0, equals))] = entry.substr(equals + 1);
  }
  return json;
}

}  // namespace raysweep
