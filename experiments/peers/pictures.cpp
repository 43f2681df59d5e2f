#include "experiments/peers/pictures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "experiments/errors.h"
#include "results/statistics/random.h"
#include "tracer/scene/scenes.h"
#include "tracer/wide/isa.h"

namespace raysweep {

namespace {

/// The quickest of Embree's ways on a sixteenth of the tiles; the best of two runs after one to warm up.
size_t quickest_way(const Scene& scene, const RenderSettings& settings, const EmbreePictures& embree) {
  constexpr size_t stride = 16;
  constexpr int runs = 2;
  size_t best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (size_t way = 0; way < embree.ways().size(); ++way) {
    PictureMaker maker(embree.make_renderer(scene, settings, way), settings.width, settings.height, 1);
    (void)maker.run(stride);
    for (int i = 0; i < runs; ++i) {
      const double seconds = maker.run(stride);
      if (seconds < least) best = way;
      least = std::min(least, seconds);
    }
  }
  return best;
}

/// One of the two, with what its rounds took.
struct Side {
  PictureMaker maker;
  double first_seconds = 0;          // of the run to warm up
  std::vector<double> per_second{};  // by rounds
  double seconds = 0;                // of all rounds

  explicit Side(PictureMaker made) : maker(std::move(made)), first_seconds(maker.run()) {}

  void run_round(double run_seconds) {
    constexpr double most_repeats = 1e4;  // where the clock saw nothing pass
    const double repeats =
        std::clamp(std::ceil(run_seconds / std::max(first_seconds, 1e-9)), 1.0, most_repeats);
    double sum = 0;
    for (int i = 0; i < static_cast<int>(repeats); ++i) sum += maker.run();
    seconds += sum;
    per_second.push_back(repeats / std::max(sum, 1e-9));
  }
};

double seconds_inside(const EmbreePictures& embree, const PictureMaker& maker) {
  double sum = 0;
  for (const auto& workspace : maker.workspaces()) sum += embree.seconds_inside(*workspace);
  return sum;
}

void run_rounds(Side& ours, Side& theirs, const PicturesRequest& request) {
  Random random(request.seed);
  for (int round = 0; round < request.rounds; ++round) {
    const bool ours_first = random.sign() > 0;
    (ours_first ? ours : theirs).run_round(request.run_seconds);
    (ours_first ? theirs : ours).run_round(request.run_seconds);
  }
}

PictureRow compare_with(int threads, const Scene& scene, const RenderSettings& settings,
                        const PicturesRequest& request, const EmbreePictures& embree, size_t way) {
  const auto side = [&](std::unique_ptr<const Renderer> renderer) {
    return Side(PictureMaker(std::move(renderer), settings.width, settings.height, threads));
  };
  Side ours = side(make_renderer(scene, settings)), theirs = side(embree.make_renderer(scene, settings, way));
  const double inside_before = seconds_inside(embree, theirs.maker);
  run_rounds(ours, theirs, request);
  std::vector<double> ratios;
  for (size_t i = 0; i < ours.per_second.size(); ++i)
    ratios.push_back(ours.per_second[i] / theirs.per_second[i]);
  PictureRow row;
  row.triangles = scene.triangle_count();
  row.width = settings.width;
  row.height = settings.height;
  row.threads = threads;
  row.ours = best_isa();
  row.embree = embree.ways()[way];
  row.ours_per_second = median(ours.per_second);
  row.embree_per_second = median(theirs.per_second);
  row.ratio = estimate_median(std::move(ratios));
  row.embree_share = (seconds_inside(embree, theirs.maker) - inside_before) / (theirs.seconds * threads);
  row.differences = pixel_differences(ours.maker.film(), theirs.maker.film());
  return row;
}

}  // namespace

const Mode& picture_mode(const std::string& name) {
  const auto mode = std::ranges::find(modes(), name, &Mode::name);
  if (mode != modes().end()) return *mode;
  std::string names;
  for (const Mode& possible : modes()) names += fmt::format("{}{}", names.empty() ? "" : ", ", possible.name);
  throw RequestError(fmt::format("no pictures of mode \"{}\"; possible: {}", name, names));
}

RenderSettings picture_settings(const Mode& mode, double scale) {
  RenderSettings settings;
  const auto scaled = [&](int length) { return std::max(1, static_cast<int>(std::lround(length * scale))); };
  settings.width = scaled(mode.width);
  settings.height = scaled(mode.height);
  settings.subpixels = mode.subpixels;
  settings.depth = mode.depth;
  settings.core = "wide";
  return settings;
}

Scene lit_scene(const std::string& name, int lights) {
  return load_scene(name, name.ends_with(".toml") ? std::min(lights, own_light_count(name)) : lights);
}

std::vector<PictureRow> compare_pictures(const std::string& scene_name, const std::string& mode_name,
                                         const PicturesRequest& request, const EmbreePictures& embree) {
  const Mode& mode = picture_mode(mode_name);
  const Scene scene = lit_scene(scene_name, mode.lights);
  const RenderSettings settings = picture_settings(mode, request.scale);
  const size_t way = quickest_way(scene, settings, embree);
  std::vector<PictureRow> rows;
  for (const int threads : picture_threads) {
    rows.push_back(compare_with(threads, scene, settings, request, embree, way));
    rows.back().scene = scene_name;
    rows.back().mode = mode_name;
  }
  return rows;
}

}  // namespace raysweep
