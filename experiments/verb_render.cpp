#include <fmt/core.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "experiments/cell_factors.h"
#include "experiments/clock.h"
#include "experiments/errors.h"
#include "experiments/machine.h"
#include "experiments/render_job.h"
#include "experiments/verbs.h"
#include "schedulers/registry.h"

namespace raysweep {

namespace {

struct RenderOptions {
  std::string mode, out;
  std::map<std::string, std::string> factors;  // as given; absent: the mode's or the default
  int frames = 1;
};

/// Finds out before the work, not after it, that the picture cannot be written.
void check_out(const std::string& out) {
  if (!out.ends_with(".png"))
    throw RequestError(fmt::format("--out {}: pictures are written as .png; name a file that ends so", out));
  const std::filesystem::path parent = std::filesystem::absolute(out).parent_path();
  if (!std::filesystem::is_directory(parent)) {
    throw RequestError(fmt::format("--out {}: there is no folder {}", out, parent.string()));
  }
  const std::string part = out + ".part";
  const bool writable = std::ofstream(part).is_open() && !std::filesystem::is_directory(out);
  std::error_code ignored;
  std::filesystem::remove(part, ignored);
  if (!writable) throw RequestError(fmt::format("--out {}: cannot be written; choose another place", out));
}

Cell make_cell(const RenderOptions& options, int pus) {
  Cell cell;
  cell.scheduler = "thread_dynamic";
  cell.item = "tiles";
  cell.threads = std::min(pus, max_threads);
  if (!options.mode.empty()) set_mode(cell, options.mode);
  for (const CellFactor& factor : cell_factors()) {
    const auto given = options.factors.find(std::string(factor.name));
    if (given != options.factors.end()) set_factor(cell, factor, given->second);
  }
  collapse_ignored_factors(cell);
  return cell;
}

nlohmann::json describe(const Cell& cell, const RenderJob& job, double seconds, int frames) {
  const RayCounts rays = job.rays();
  const auto n = static_cast<uint64_t>(frames);
  return {{"image_hash", job.film().hash()},
          {"seconds", seconds / frames},
          {"fps", frames / seconds},
          {"frames", frames},
          {"width", cell.settings.width},
          {"height", cell.settings.height},
          {"rays",
           {{"primary", rays.primary / n},
            {"shadow", rays.shadow / n},
            {"reflected", rays.reflected / n},
            {"refracted", rays.refracted / n}}},
          {"mrays_per_second", static_cast<double>(rays.total()) / seconds / 1e6},
          {"build_seconds", job.build_seconds()},
          {"cell", cell.key()},
          {"threads", cell.threads},
          {"threads_seen", job.log().workers_seen()}};
}

int run(const RenderOptions& options, bool json) {
  check_out(options.out);
  const int pus = detect_machine().pus;
  const Cell cell = make_cell(options, pus);
  if (cell.threads > pus)
    fmt::print(stderr, "note: {} threads on {} processors: oversubscribed\n", cell.threads, pus);
  if (static_cast<size_t>(cell.settings.width) * static_cast<size_t>(cell.settings.height) > max_png_pixels) {
    throw RequestError(
        fmt::format("--width {} --height {}: too large for a PNG file, which holds {} pixels here",
                    cell.settings.width, cell.settings.height, max_png_pixels));
  }
  RenderJob job(cell);
  const double begin = now_seconds();
  for (int i = 0; i < options.frames; ++i) job.frame();
  const double seconds = now_seconds() - begin;
  write_png(job.film(), options.out);
  const nlohmann::json result = describe(cell, job, seconds, options.frames);
  if (json) {
    fmt::print("{}\n", result.dump(1));
    return exit_done;
  }
  const auto& rays = result["rays"];
  fmt::print("{}: {} × {}, {:.3f} s a frame ({:.3g} fps) by {} on {} of {} threads\n", options.out,
             cell.settings.width, cell.settings.height, seconds / options.frames, options.frames / seconds,
             cell.scheduler, job.log().workers_seen(), cell.threads);
  fmt::print("rays: {} primary, {} shadow, {} reflected; {:.2f} Mrays/s; hierarchy built in {:.3f} s\n",
             rays["primary"].get<uint64_t>(), rays["shadow"].get<uint64_t>(),
             rays["reflected"].get<uint64_t>(), result["mrays_per_second"].get<double>(),
             job.build_seconds());
  fmt::print("picture {}\n", job.film().hash());
  return exit_done;
}

}  // namespace

void add_render(CommandLine& line) {
  CLI::App* const verb = add_verb(line, "render", "one picture, with its time, rays and hash");
  static RenderOptions options;
  verb->add_option("--mode", options.mode, "low, middle, hard or very_hard: size and effort as published");
  for (const CellFactor& factor : cell_factors()) {
    const std::string name(factor.name);
    verb->add_option_function<std::string>(
        "--" + name, [name](const std::string& value) { options.factors[name] = value; },
        std::string(factor.possible));
  }
  verb->add_option("--frames", options.frames, "frames to render; times are their mean")
      ->check(CLI::Range(1, 1000000));
  verb->add_option("--out", options.out, "the picture, a .png file")->required();
  verb->callback([&line] { line.action = [&line] { return run(options, line.json); }; });
}

}  // namespace raysweep
