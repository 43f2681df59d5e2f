// Where over two difficulties at once do methods of intersection miss hits, and where do the triangles of
// scenes lie there? Writes a folder of records that scripts/chart_study draws.
#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "experiments/command_line.h"
#include "experiments/intersection/atlas.h"
#include "results/tables/write_file.h"
#include "tracer/scene/scenes.h"

namespace raysweep {

namespace {

constexpr int atlas_schema = 1;

struct Options {
  std::string out;
  std::vector<std::string> scenes{"chair-ball"};
  int seed = 1, rays = 1000, triangles = 400;
};

nlohmann::json head_of(const AtlasMap& map, const Options& options, const char* part) {
  return {{"schema", atlas_schema}, {"kind", "atlas"}, {"experiment", "atlas"},
          {"seed", options.seed},   {"map", map.id},   {"part", part}};
}

template <class T>
void add_grids(std::string& lines, const AtlasMap& map, const Options& options, const char* precision) {
  const auto seed = static_cast<uint64_t>(options.seed);
  for (const AtlasGrid& grid : run_atlas<T>(map, seed, static_cast<size_t>(options.rays))) {
    nlohmann::json json = head_of(map, options, "grid");
    json.update({{"method", grid.method}, {"precision", precision}, {"rays", options.rays}});
    json.update({{"x_of", map.x_of}, {"y_of", map.y_of}, {"x", map.x}, {"y", map.y}});
    json.update({{"hits", grid.hits}, {"false_misses", grid.false_misses}});
    lines += json.dump() + "\n";
  }
}

void add_scene(std::string& lines, const AtlasMap& map, const Options& options, const Scene& scene,
               const std::string& name) {
  Random random(static_cast<uint64_t>(options.seed));
  nlohmann::json x = nlohmann::json::array(), y = x;
  for (const AtlasPlace& place : places_of(map, scene, random, static_cast<size_t>(options.triangles))) {
    x.push_back(place.x);
    y.push_back(place.y);
  }
  nlohmann::json json = head_of(map, options, "scene");
  json.update({{"scene", name}, {"x", std::move(x)}, {"y", std::move(y)}});
  lines += json.dump() + "\n";
}

void run(const Options& options) {
  // First what may be wrong.
  std::string scenes;
  for (const std::string& name : options.scenes) {
    const Scene scene = load_scene(name);
    for (const AtlasMap& map : all_atlas_maps()) add_scene(scenes, map, options, scene, name);
  }
  std::string grids;
  for (const AtlasMap& map : all_atlas_maps()) {
    add_grids<float>(grids, map, options, "float");
    add_grids<double>(grids, map, options, "double");
  }
  std::filesystem::create_directories(options.out);
  write_file(std::filesystem::path(options.out) / "records.jsonl", grids + scenes);
}

int start(int argc, char** argv) {
  Command app{"Hits that methods of intersection miss, over two difficulties at once", "atlas"};
  Options options;
  app.add_option("--out", options.out, "the folder in which records.jsonl is written").required();
  app.add_option("--scene", options.scenes,
                 "a name or a file whose triangles are placed; repeatable (chair-ball)")
      .repeated();
  app.add_option("--seed", options.seed, "of all that is drawn (1)").at_least_0();
  app.add_option("--rays", options.rays, "of each cell of a map (1000)").range(1, 1000000);
  app.add_option("--triangles", options.triangles, "of a scene at most (400)").range(1, 100000);
  if (const auto code = app.parse(argc, argv)) return *code;
  try {
    run(options);
    return 0;
  } catch (const std::exception& error) {
    fmt::print(stderr, "atlas: {}\n", error.what());
    return 2;
  }
}

}  // namespace

}  // namespace raysweep

int main(int argc, char** argv) { return raysweep::start(argc, argv); }
