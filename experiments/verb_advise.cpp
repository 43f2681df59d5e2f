#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "experiments/advise/advice_report.h"
#include "experiments/cell_factors.h"
#include "experiments/errors.h"
#include "experiments/verbs.h"
#include "tracer/scene/scenes.h"

namespace raysweep {

namespace {

constexpr double longest_rounds = 600;  // seconds
constexpr double patience = 5;  // times as long as asked for, where rounds do not tell which is quickest

/// Factors that decide what the pictures cost which are timed. Methods and precisions are what is asked for.
constexpr std::string_view picture_factors[] = {"width",           "height",   "subpixels", "pattern",
                                                "depth",           "branches", "lights",    "accel",
                                                "pixel_tolerance", "leaf",     "core",      "isa"};

struct AdviseOptions {
  std::string scene, mode;
  std::map<std::string, std::string> factors;
  AdviceRequest request;
};

Cell cell_of(const AdviseOptions& options) {
  Cell cell;
  cell.scene = options.scene;
  if (!options.mode.empty()) set_mode(cell, options.mode);
  // So few pixels that a picture takes some tens of milliseconds at most, and there are many rounds.
  cell.settings.width = 96;
  cell.settings.height = 72;
  for (const auto& [name, value] : options.factors) set_factor(cell, *find_factor(name), value);
  return cell;
}

int run(AdviseOptions options, bool as_json) {
  if (const std::string problem = tolerance_problem(options.request.tolerance); !problem.empty())
    throw RequestError(problem);
  // Written so that what is no number is refused, too.
  if (!(options.request.rounds.seconds >= 0 && options.request.rounds.seconds <= longest_rounds)) {
    throw RequestError(fmt::format("seconds = {} is out of range: a number from 0 to {} is possible",
                                   options.request.rounds.seconds, longest_rounds));
  }
  const Cell cell = cell_of(options);
  const Scene scene = load_scene(cell.scene, cell.lights);
  options.request.settings = cell.settings;
  options.request.rounds.longest = patience * options.request.rounds.seconds;
  const Advice advice = advise(scene, options.request);
  if (as_json) {
    fmt::print("{}\n", to_json(advice).dump(1));
  } else {
    fmt::print("{}\n", to_text(advice_table(advice)));
    if (advice.measured_hits > 0)
      fmt::print("{}\n{}\n", to_text(numbers_table(advice)), to_text(study_table(advice)));
    fmt::print("{}\n", advice_text(advice.all, advice.ranking, advice.tolerance));
  }
  return advice.ranking.choice ? exit_done : exit_failed;
}

}  // namespace

void add_advise(CommandLine& line) {
  Command verb =
      add_verb(line, "advise", "the cheapest method and precision that keep hit points right, with evidence");
  static AdviseOptions options;
  verb.add_option("scene", options.scene, "a built-in name, a scene file (.toml) or a mesh file").required();
  verb.add_option("--hit-tolerance", options.request.tolerance,
                  "how far a hit point may be off, as a share of the scene's size (1e-4)");
  verb.add_option("--mode", options.mode,
                  "effort of the pictures that are timed: low, middle, hard or very_hard; not their size");
  for (const std::string_view name : picture_factors) {
    std::string option = "--" + std::string(name);
    std::ranges::replace(option, '_', '-');
    verb.add_option_function(
        option, [name](const std::string& value) { options.factors[std::string(name)] = value; },
        std::string(find_factor(name)->possible));
  }
  verb.add_option(
      "--seconds", options.request.rounds.seconds,
      "that rounds of pictures may take together (6), up to five times as long where they do not tell which "
      "is quickest; seven rounds there are in any case");
  verb.add_option("--seed", options.request.rounds.seed, "of the order in each round (1)");
  verb.callback([&line] { line.action = [&line] { return run(options, line.json); }; });
}

}  // namespace raysweep
