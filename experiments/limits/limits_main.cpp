// How much do rays visit, and how long does it take? What scripts/record_limits asks of a build that counts,
// of one that does not, and of one under Callgrind.
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "experiments/command_line.h"
#include "experiments/errors.h"
#include "experiments/limits/batch_runs.h"
#include "tracer/scene/scenes.h"

namespace raysweep {

namespace {

struct Options {
  std::vector<std::string> scenes{"chair-ball"}, isas{std::string(best_isa())};
  std::vector<std::string> kinds{ray_kind_names.begin(), ray_kind_names.end()};
  std::vector<std::string> groupings{"single", "packets"};
  int width = 1024, height = 768, rounds = 7;
  double seconds = 0.05;
  bool once = false;
};

nlohmann::json to_json(const VisitCounts& visits) {
  auto json = nlohmann::json::object();
  for (size_t i = 0; i < visit_names.size(); ++i) json[visit_names[i]] = visits[static_cast<Visited>(i)];
  return json;
}

const char* name_of(Grouping grouping) { return grouping == Grouping::single ? "single" : "packets"; }

bool is_among(const std::string& name, const std::vector<std::string>& names) {
  return std::ranges::find(names, name) != names.end();
}

/// One line for each run.
void tell(const SceneRuns& scene, const std::string& name, RayKind kind, const Options& options) {
  std::vector<BatchRun> runs = scene.runs(kind, options.width, options.height);
  std::erase_if(runs,
                [&](const BatchRun& run) { return !is_among(name_of(run.grouping), options.groupings); });
  std::vector<VisitCounts> visits;
  for (const BatchRun& run : runs) visits.push_back(run.trace());
  std::vector<double> seconds;
  if (!options.once) seconds = cpu_seconds(runs, options.rounds, options.seconds);
  for (size_t i = 0; i < runs.size(); ++i) {
    nlohmann::json line{{"scene", name},
                        {"triangles", scene.triangle_count()},
                        {"kind", ray_kind_names[static_cast<size_t>(kind)]},
                        {"grouping", name_of(runs[i].grouping)},
                        {"isa", runs[i].isa},
                        {"rays", runs[i].rays}};
    if (counts_visits) line["visits"] = to_json(visits[i]);
    if (!options.once)
      line["ns_per_ray"] = 1e9 * seconds[i] / static_cast<double>(std::max<size_t>(runs[i].rays, 1));
    fmt::print("{}\n", line.dump());
  }
}

void run(const Options& options) {
  for (const std::string& isa : options.isas) {
    if (!runs_here(isa))
      throw RequestError(fmt::format("--isa {}: does not run here; raysweep list isas tells what does", isa));
  }
  if (!options.once) fmt::print("{}\n", nlohmann::json{{"gigahertz", measure_gigahertz()}}.dump());
  for (const std::string& name : options.scenes) {
    const SceneRuns scene(load_scene(name), options.isas);
    for (const RayKind kind : {RayKind::primary, RayKind::shadow, RayKind::mirror, RayKind::diffuse})
      if (is_among(ray_kind_names[static_cast<size_t>(kind)], options.kinds))
        tell(scene, name, kind, options);
  }
}

int start(int argc, char** argv) {
  Command app{"How much do rays of each kind visit in the wide core, and how long does it take?", "limits"};
  Options options;
  app.add_option("--scene", options.scenes, "a name or a file; more than one by repeating").repeated();
  app.add_option("--isa", options.isas, "an instruction set; more than one by repeating").repeated();
  app.add_option("--kinds", options.kinds, "primary,shadow,mirror,diffuse: which rays (all)")
      .by_commas()
      .one_of(options.kinds);
  app.add_option("--groupings", options.groupings, "single,packets (both)")
      .by_commas()
      .one_of(options.groupings);
  constexpr int largest_side = 16384;
  app.add_option("--width", options.width, "of the picture that rays are sent out for (1024)")
      .range(1, largest_side);
  app.add_option("--height", options.height, "(768)").range(1, largest_side);
  app.add_option("--rounds", options.rounds, "of which times are medians (7)").range(1, 10000);
  app.add_option("--seconds", options.seconds, "that a time is the mean over, at least (0.05)").above_0();
  app.add_flag("--once", options.once, "trace each batch once and tell no times");
  if (const auto code = app.parse(argc, argv)) return *code;
  try {
    run(options);
    return exit_done;
  } catch (const std::exception& error) {
    fmt::print(stderr, "limits: {}\n", error.what());
    return exit_refused;
  }
}

}  // namespace

}  // namespace raysweep

int main(int argc, char** argv) { return raysweep::start(argc, argv); }
