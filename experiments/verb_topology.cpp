#include <fmt/core.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "experiments/errors.h"
#include "experiments/machine/machine.h"
#include "experiments/machine/sibling_probe.h"
#include "experiments/verbs.h"
#include "results/tables/table.h"
#include "schedulers/options.h"

namespace raysweep {

namespace {

struct TopologyOptions {
  int threads = 0;
  std::string pin = "none";
  bool probe = false;
};

/// Thread → processor, with what it shares; the earlier threads that are on the same core or processor count.
struct Place {
  int thread;
  HardwareThread on;
  int on_processor_before, on_core_before;
};

std::vector<Place> places(const Topology& topology, const std::vector<int>& placement) {
  std::vector<Place> list;
  for (size_t t = 0; t < placement.size(); ++t) {
    Place place{static_cast<int>(t), *topology.find(placement[t]), 0, 0};
    for (const Place& earlier : list) {
      place.on_processor_before += earlier.on.processor == place.on.processor;
      place.on_core_before += earlier.on.core == place.on.core;
    }
    list.push_back(place);
  }
  return list;
}

nlohmann::json to_json(const std::vector<Place>& list) {
  auto json = nlohmann::json::array();
  for (const Place& p : list) {
    json.push_back({{"thread", p.thread},
                    {"processor", p.on.processor},
                    {"core", p.on.core},
                    {"hardware_thread", p.on.sibling},
                    {"package", p.on.package},
                    {"cache", p.on.cache}});
  }
  return json;
}

Table table_of(const std::vector<Place>& list, const TopologyOptions& options) {
  Table table;
  table.caption = fmt::format("{} threads, pin {}", options.threads, options.pin);
  for (const char* title : {"thread", "processor", "core", "hardware thread", "cache", "package"})
    table.columns.push_back({title});
  table.columns.push_back({"shares", false});
  for (const Place& p : list) {
    std::vector<std::string> cells;
    for (const int v : {p.thread, p.on.processor, p.on.core, p.on.sibling, p.on.cache, p.on.package})
      cells.push_back(v < 0 ? "–" : std::to_string(v));
    cells.push_back(p.on_processor_before > 0 ? "its processor (oversubscribed)"
                    : p.on_core_before > 0    ? "its core (hyper-threading)"
                                              : "");
    table.rows.push_back(std::move(cells));
  }
  return table;
}

/// What processors do to each other; empty unless asked for.
std::vector<PairSlowdown> probe(const TopologyOptions& options, const Topology& topology) {
  if (!options.probe) return {};
  if (topology.processors() > most_probed_processors) {
    throw RequestError(
        fmt::format("--probe tries every pair of up to {} processors; here are {}: allow fewer by taskset",
                    most_probed_processors, topology.processors()));
  }
  return probe_siblings(topology.processor_numbers());
}

nlohmann::json to_json(const std::vector<PairSlowdown>& pairs, const Topology& topology) {
  nlohmann::json json{{"disagreements", disagreements(pairs, topology)}, {"pairs", nlohmann::json::array()}};
  for (const PairSlowdown& pair : pairs)
    json["pairs"].push_back({{"processors", {pair.first, pair.second}}, {"slowdown", pair.slowdown}});
  return json;
}

void print(const std::vector<PairSlowdown>& pairs, const Topology& topology) {
  const auto sentences = disagreements(pairs, topology);
  fmt::print("\n");
  for (const std::string& sentence : sentences) fmt::print("{}\n", sentence);
  const auto worst = std::ranges::max_element(pairs, {}, &PairSlowdown::slowdown);
  if (pairs.empty()) fmt::print("no pair of processors to probe\n");
  if (sentences.empty() && worst != pairs.end()) {
    fmt::print(
        "probed every pair of processors ({}): which share a core is as the topology says; at worst a pair "
        "takes "
        "{:.2f} "
        "times as long together as alone\n",
        pairs.size(), worst->slowdown);
  }
}

int run(const TopologyOptions& options, bool as_json) {
  const Machine machine = detect_machine();
  const Topology& t = machine.topology;
  if (const std::string problem = pin_problem(options.pin, t.processor_numbers()); !problem.empty())
    throw RequestError(problem);
  const std::vector<PairSlowdown> pairs = probe(options, t);
  const std::vector<Place> list = places(t, place(options.pin, options.threads, t));
  if (as_json) {
    nlohmann::json json = to_json(machine);
    if (options.probe) json["probe"] = to_json(pairs, t);
    if (options.threads > 0) json["placement"] = {{"pin", options.pin}, {"threads", to_json(list)}};
    fmt::print("{}\n", json.dump(1));
    return exit_done;
  }
  fmt::print("{}: {}, {}\n", machine.host, t.cpu, machine.kernel);
  fmt::print("allowed here: {} packages, {} cores, {} processors{}\n\n", t.packages(), t.cores(),
             t.processors(), t.has_smt() ? "" : "; no hyper-threading");
  for (const std::string& object : t.outline) fmt::print("{}\n", object);
  if (options.probe) print(pairs, t);
  if (options.threads == 0) return exit_done;
  if (list.empty()) {
    fmt::print("\n{} threads, pin none: the operating system places them as it likes\n", options.threads);
  } else {
    fmt::print("\n{}", to_text(table_of(list, options)));
  }
  if (options.threads > t.processors()) {
    fmt::print("{} more than there are processors (oversubscribed)\n", options.threads - t.processors());
  }
  return exit_done;
}

}  // namespace

void add_topology(CommandLine& line) {
  Command verb = add_verb(line, "topology", "the machine as hwloc sees it, and where each thread would go");
  static TopologyOptions options;
  verb.add_option("--threads", options.threads, "so many threads").range(min_threads, max_threads);
  verb.add_option("--pin", options.pin, "placed by this policy, see `raysweep list pins`");
  verb.add_flag("--probe", options.probe,
                "find out which processors slow each other down: a virtual machine's topology can lie");
  verb.callback([&line] { line.action = [&line] { return run(options, line.json); }; });
}

}  // namespace raysweep
