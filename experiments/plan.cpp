#include "experiments/plan.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <numeric>
#include <random>

#include "experiments/cell_factors.h"
#include "experiments/cell_record.h"
#include "tracer/scene/scenes.h"

namespace raysweep {

namespace {

class Planner {
 public:
  Planner(Plan& plan, const MachineSize& machine) : plan_(plan), machine_(machine) {}

  void add(Cell cell, bool asked) {
    collapse_ignored_factors(cell);
    const std::string key = cell.key();
    const auto known = std::ranges::find(plan_.cells, key, &PlannedCell::key);
    if (known != plan_.cells.end()) {
      known->asked = known->asked || asked;
    } else {
      plan_.cells.push_back({std::move(cell), key, asked});
    }
  }

  /// The cell itself after the cells that it is compared with.
  void add_with_bases(Cell cell) {
    collapse_ignored_factors(cell);
    Cell serial = cell;
    serial.scheduler = "serial";
    serial.threads = 1;
    add(serial, false);
    Cell one = cell;
    one.threads = 1;
    add(one, false);
    Cell corun = serial;
    corun.processes = std::min(cell.threads, machine_.pus);
    if (corun.processes > 1) add(corun, false);
    add(cell, true);
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
  plan.seed = config.measure.seed;
  Planner planner(plan, machine);
  const int lights = own_light_count(config.scene);
  int most = 0;
  const std::vector<std::string> modes = config.modes.empty() ? std::vector<std::string>{""} : config.modes;
  for (const std::string& mode : modes) {
    Cell base;
    base.scene = config.scene;
    if (!mode.empty()) set_mode(base, mode);
    std::vector<Cell> cells{base};
    for (const Axis& axis : config.axes) {
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
      most = std::max(most, cell.lights.emplace(cell.lights.value_or(lights)));
      planner.add_with_bases(cell);
    }
  }
  (void)load_scene(config.scene, most);  // a file that has fewer lights is refused before anything runs
  return plan;
}

std::vector<size_t> Plan::order(int round) const {
  std::vector<size_t> indices(cells.size());
  std::iota(indices.begin(), indices.end(), size_t{0});
  // Fisher and Yates by hand: std::shuffle may differ between libraries, and a plan must not. The modulo's
  // bias is below cells/2³².
  std::mt19937 random(static_cast<uint32_t>(seed * 1000003 + static_cast<uint64_t>(round)));
  for (size_t i = indices.size(); i > 1; --i) std::swap(indices[i - 1], indices[random() % i]);
  return indices;
}

nlohmann::json to_json(const Plan& plan) {
  nlohmann::json json{{"experiment", plan.experiment},
                      {"title", plan.title},
                      {"interval", plan.interval},
                      {"seed", plan.seed},
                      {"rounds", plan.rounds}};
  for (const PlannedCell& planned : plan.cells) {
    Record blank = record_of(planned.cell);
    blank.experiment = plan.experiment;
    json["cells"].push_back(to_json(blank));
  }
  for (int round = 0; round < plan.rounds; ++round) json["order"].push_back(plan.order(round));
  return json;
}

}  // namespace raysweep
