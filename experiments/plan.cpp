#include "experiments/plan.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "experiments/cell_factors.h"
#include "experiments/cell_record.h"
#include "tracer/scene/scenes.h"

namespace raysweep {

namespace {

class Planner {
 public:
  Planner(Plan& plan, const MachineSize& machine) : plan_(plan), machine_(machine) {}

  /// The cell itself after the cells that it is compared with.
  void add_with_bases(Cell cell) {
    collapse_ignored_factors(cell);
    const Cell serial = serial_cell(cell);
    Cell one = cell;
    one.threads = 1;
    one.slowdown = 0;
    Cell corun = serial;
    corun.processes = std::min(cell.threads, machine_.pus);
    std::vector<std::string> bases{add(serial, false), add(one, false)};
    if (corun.processes > 1) bases.push_back(add(corun, false));
    if (cell.slowdown > 0) {
      Cell original = cell;
      original.slowdown = 0;
      bases.push_back(add(original, false));
    }
    const std::string key = add(cell, true);
    std::erase(bases, key);  // the serial cell is its own base
    std::ranges::find(plan_.cells, key, &PlannedCell::key)->bases = std::move(bases);
  }

  /// Two threads that wait for each other feel more of the machine's noise than one: the twins are of the
  /// cell with the most threads that has a processor for each.
  void add_twins(int count) {
    const auto rank = [&](const Cell& cell) {
      return std::pair(cell.slowdown == 0, cell.threads <= machine_.pus ? cell.threads : 0);
    };
    const PlannedCell* most = nullptr;
    for (const PlannedCell& planned : plan_.cells) {
      if (planned.asked && (!most || rank(planned.cell) > rank(most->cell))) most = &planned;
    }
    if (!most) return;
    const PlannedCell original = *most;  // adding moves it
    for (Cell twin = original.cell; twin.twin < count;) {
      twin.twin++;
      const std::string key = add(twin, false);
      std::ranges::find(plan_.cells, original.key, &PlannedCell::key)->bases.push_back(key);
    }
  }

  /// Its key.
  std::string add(Cell cell, bool asked) {
    collapse_ignored_factors(cell);
    std::string key = cell.key();
    const auto known = std::ranges::find(plan_.cells, key, &PlannedCell::key);
    if (known != plan_.cells.end()) {
      known->asked = known->asked || asked;
    } else {
      plan_.cells.push_back({std::move(cell), key, asked});
    }
    return key;
  }

 private:
  Plan& plan_;
  const MachineSize machine_;
};

}  // namespace

Plan make_plan(const Config& config, const MachineSize& machine) {
  Plan plan;
  plan.experiment = config.experiment;
  plan.title = config.title;
  plan.interval = config.measure.interval;
  plan.rounds = config.measure.launches;
  plan.max_rounds = config.measure.max_launches;
  plan.seed = config.measure.seed;
  plan.sheet = config.claims.sheet;
  Planner planner(plan, machine);
  const int lights = own_light_count(config.scene);
  int most = 0;
  const std::vector<std::string> modes = config.modes.empty() ? std::vector<std::string>{""} : config.modes;
  for (const std::string& mode : modes) {
    Cell base;
    base.scene = config.scene;
    if (!mode.empty()) set_mode(base, mode);
    std::vector<Cell> cells{base};
    for (const SweepAxis& axis : config.axes) {
      std::vector<Cell> extended;
      for (const Cell& cell : cells) {
        for (const auto& point : axis.points) {
          Cell next = cell;
          for (size_t i = 0; i < axis.names.size(); ++i)
            set_factor(next, *find_factor(axis.names[i]), point[i]);
          extended.push_back(std::move(next));
        }
      }
      cells = std::move(extended);
    }
    for (Cell& cell : cells) {
      refuse_impossible(cell, config.file);
      most = std::max(most, cell.lights.emplace(cell.lights.value_or(lights)));
      if (config.measure.bases) {
        planner.add_with_bases(cell);
      } else {
        planner.add(cell, true);
      }
    }
  }
  planner.add_twins(config.measure.twins);
  (void)load_scene(config.scene, most);  // a file that has fewer lights is refused before anything runs
  return plan;
}

uint64_t turn(uint64_t seed, int round, const std::string& key) {
  // FNV-1a over the key, then SplitMix64's finaliser (Steele, Lea & Flood 2014), so that nearby rounds and
  // keys have nothing in common.
  uint64_t hash = 14695981039346656037u ^ (seed * 1000003 + static_cast<uint64_t>(round));
  for (const char c : key) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211u;
  hash = (hash ^ (hash >> 30)) * 0xbf58476d1ce4e5b9u;
  hash = (hash ^ (hash >> 27)) * 0x94d049bb133111ebu;
  return hash ^ (hash >> 31);
}

std::vector<size_t> Plan::order(int round) const {
  std::vector<std::pair<uint64_t, size_t>> turns;
  for (size_t i = 0; i < cells.size(); ++i) turns.emplace_back(turn(seed, round, cells[i].key), i);
  std::ranges::sort(turns);
  std::vector<size_t> indices;
  for (const auto& [at, index] : turns) indices.push_back(index);
  return indices;
}

nlohmann::json to_json(const Plan& plan) {
  nlohmann::json json{{"experiment", plan.experiment}, {"title", plan.title},
                      {"interval", plan.interval},     {"seed", plan.seed},
                      {"rounds", plan.rounds},         {"max_rounds", plan.max_rounds}};
  for (const PlannedCell& planned : plan.cells) {
    Record blank = record_of(planned.cell);
    blank.experiment = plan.experiment;
    json["cells"].push_back(to_json(blank));
  }
  for (int round = 0; round < plan.rounds; ++round) json["order"].push_back(plan.order(round));
  add_to_plan(json, plan.sheet);
  return json;
}

}  // namespace raysweep
