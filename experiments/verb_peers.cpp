#include <fmt/core.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "experiments/errors.h"
#include "experiments/peers/peers_report.h"
#include "experiments/verbs.h"

namespace raysweep {

namespace {

constexpr double longest_run = 60;  // seconds

struct PeersOptions {
  std::vector<std::string> scenes, kinds, picture_modes;
  PeersRequest request;
};

RayKind kind_of(const std::string& name) {
  const auto found = std::ranges::find(ray_kind_names, name);
  if (found == ray_kind_names.end())
    throw RequestError(fmt::format("--kinds {}: unknown; possible: primary, shadow, mirror, diffuse", name));
  return static_cast<RayKind>(found - ray_kind_names.begin());
}

PicturesRequest pictures_of(const PeersOptions& options) {
  PicturesRequest pictures = options.request.pictures;
  if (!(pictures.scale > 0 && pictures.scale <= 1)) {
    throw RequestError(fmt::format(
        "picture-scale = {} is out of range: a number above 0 and up to 1 is possible", pictures.scale));
  }
  pictures.run_seconds = options.request.duel.run_seconds;
  pictures.seed = options.request.duel.seed;
  if (options.picture_modes == std::vector<std::string>{"none"}) return pictures;
  if (options.picture_modes.empty())
    for (const Mode& mode : modes()) pictures.modes.emplace_back(mode.name);
  for (const std::string& name : options.picture_modes) pictures.modes.emplace_back(picture_mode(name).name);
  return pictures;
}

PeersRequest request_of(const PeersOptions& options) {
  PeersRequest request = options.request;
  request.scenes = options.scenes.empty() ? std::vector<std::string>{"chair-ball"} : options.scenes;
  // Written so that what is no number is refused, too.
  if (!(request.duel.run_seconds >= 0 && request.duel.run_seconds <= longest_run)) {
    throw RequestError(fmt::format("seconds = {} is out of range: a number from 0 to {} is possible",
                                   request.duel.run_seconds, longest_run));
  }
  if (!options.kinds.empty()) {
    request.kinds.clear();
    for (const std::string& kind : options.kinds) request.kinds.push_back(kind_of(kind));
  }
  request.pictures = pictures_of(options);
  return request;
}

int run(const PeersOptions& options, bool as_json) {
  const PeersRequest request = request_of(options);
  const EmbreeModule& embree = load_embree();
  const auto say = [](const std::string& next) { fmt::print(stderr, "{}\n", next); };
  const PeersResult result = compare_with_embree(request, embree, say);
  for (const std::string& sentence : result.left_out) fmt::print(stderr, "note: {}\n", sentence);
  if (as_json) {
    fmt::print("{}\n", to_json(result).dump(1));
  } else {
    fmt::print("{}\n", to_text(rays_table(result, request, embree)));
    if (!result.pictures.empty()) fmt::print("{}\n", to_text(pictures_table(result, request, embree)));
    fmt::print("{}", to_text(builds_table(result)));
  }
  return exit_done;
}

}  // namespace

void add_peers(CommandLine& line) {
  Command verb =
      add_verb(line, "peers", "our tracer against Embree: the same rays in one thread, and whole pictures");
  static PeersOptions options;
  verb.add_option("--scene", options.scenes,
                  "a name or a file; more than one by repeating (default chair-ball)")
      .repeated();
  // 2²⁸ rays, laid out for every width of packets, are about as many as a large machine holds.
  constexpr int largest_side = 16384;
  verb.add_option("--width", options.request.width, "of the picture that rays are sent out for (1024)")
      .range(1, largest_side);
  verb.add_option("--height", options.request.height, "(768)").range(1, largest_side);
  // Fewer than six have no interval.
  verb.add_option("--rounds", options.request.duel.rounds, "in each of which everyone runs once (15)")
      .range(6, 10000);
  verb.add_option("--seconds", options.request.duel.run_seconds,
                  "that a run takes at least, by repeating shorter ones (0.02)");
  verb.add_option("--kinds", options.kinds, "primary,shadow,mirror,diffuse: which rays (all)").by_commas();
  verb.add_option("--picture-modes", options.picture_modes,
                  "low,middle,hard,very_hard: of which pictures are made (all), or none")
      .by_commas();
  verb.add_option("--picture-scale", options.request.pictures.scale, "of their width and height (0.5)");
  verb.add_option("--picture-rounds", options.request.pictures.rounds, "in each of which both make one (7)")
      .range(6, 10000);
  verb.add_option("--seed", options.request.duel.seed, "of diffuse rays and of the order in rounds (1)");
  verb.callback([&line] { line.action = [&line] { return run(options, line.json); }; });
}

}  // namespace raysweep
