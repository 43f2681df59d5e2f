#include <fmt/core.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>

#include "experiments/advise/advisor.h"
#include "experiments/cell_factors.h"
#include "experiments/clock.h"
#include "experiments/errors.h"
#include "experiments/render_job.h"
#include "experiments/render_report.h"
#include "experiments/render_watch.h"
#include "experiments/trace.h"
#include "experiments/verbs.h"
#include "schedulers/placement.h"
#include "schedulers/registry.h"
#include "tracer/film_exr.h"
#include "tracer/scene/scenes.h"
#include "tracer/whole_file.h"

namespace raysweep {

namespace {

struct RenderOptions {
  std::string mode, out, reference, trace;
  std::map<std::string, std::string> factors;  // as given; absent: the mode's or the default
  std::optional<double> hit_tolerance;         // of the method "auto"
  int frames = 1;
};

/// Finds out before the work, not after it, that a file cannot be written.
void check_writable(const char* option, const std::string& path) {
  const std::filesystem::path parent = std::filesystem::absolute(path).parent_path();
  if (!std::filesystem::is_directory(parent))
    throw RequestError(fmt::format("{} {}: there is no folder {}", option, path, parent.string()));
  const std::string part = part_of(path);
  const bool writable = std::ofstream(part).is_open() && !std::filesystem::is_directory(path);
  std::error_code ignored;
  std::filesystem::remove(part, ignored);
  if (!writable)
    throw RequestError(fmt::format("{} {}: cannot be written; choose another place", option, path));
}

void check_out(const std::string& out) {
  if (!out.ends_with(".png") && !out.ends_with(".exr")) {
    throw RequestError(
        fmt::format("--out {}: pictures are written as .png or .exr; name a file that ends so", out));
  }
  check_writable("--out", out);
}

void check_trace(const RenderOptions& options) {
  if (options.trace.empty()) return;
  if (!options.trace.ends_with(".json")) {
    throw RequestError(
        fmt::format("--trace {}: timelines are written as .json; name a file that ends so", options.trace));
  }
  check_writable("--trace", options.trace);
}

/// The reference of the picture's size; another size is told before a large file is read.
ExrPicture read_reference(const RenderOptions& options, const Cell& cell) {
  const std::string& file = options.reference;
  std::error_code error;
  if (std::filesystem::equivalent(file, options.out, error))
    throw RequestError(fmt::format("--out {}: is the reference itself, which would be lost", options.out));
  try {
    const auto [width, height] = exr_size(file);
    if (width != cell.settings.width || height != cell.settings.height) {
      throw RequestError(fmt::format("--reference {}: is {} × {}, the picture {} × {}; they must be equal",
                                     file, width, height, cell.settings.width, cell.settings.height));
    }
    return read_exr(file);
  } catch (const RequestError&) {
    throw;
  } catch (const std::runtime_error& error) {
    throw RequestError(fmt::format("--reference {}", error.what()));
  }
}

bool chooses_method(const RenderOptions& options) {
  const auto method = options.factors.find("method");
  return method != options.factors.end() && method->second == "auto";
}

void check_tolerance(const RenderOptions& options) {
  if (!options.hit_tolerance) return;
  if (!chooses_method(options)) {
    throw RequestError(fmt::format("--hit-tolerance {}: chooses a method, which only --method auto asks for",
                                   *options.hit_tolerance));
  }
  if (const std::string problem = tolerance_problem(*options.hit_tolerance); !problem.empty())
    throw RequestError(problem);
}

/// Takes the cheapest method that keeps the tolerance, of the precision that was given if one was; says which
/// in `chosen`.
void choose_method(Cell& cell, const RenderOptions& options, std::optional<ChosenMethod>& chosen) {
  if (!chooses_method(options)) return;
  const double tolerance = options.hit_tolerance.value_or(default_hit_tolerance);
  const bool is_given = options.factors.contains("precision");
  const Prediction choice = choose_method(load_scene(cell.scene, cell.lights), cell.settings.core,
                                          is_given ? cell.settings.precision : "", tolerance);
  cell.settings.method = choice.choice.method;
  cell.settings.precision = choice.choice.precision;
  chosen = {choice.bound, tolerance};
}

Cell make_cell(const RenderOptions& options, const Topology& topology, std::optional<ChosenMethod>& chosen) {
  Cell cell;
  cell.scheduler = "thread_dynamic";
  cell.item = "tiles";
  cell.threads = std::min(topology.processors(), max_threads);
  if (!options.mode.empty()) set_mode(cell, options.mode);
  for (const CellFactor& factor : cell_factors()) {
    const auto given = options.factors.find(std::string(factor.name));
    if (given == options.factors.end()) continue;
    if (factor.name == "method" && chooses_method(options)) continue;
    set_factor(cell, factor, given->second);
  }
  if (const std::string problem = pin_problem(cell.pin, topology.processor_numbers()); !problem.empty())
    throw RequestError(problem);
  refuse_impossible(cell);
  choose_method(cell, options, chosen);
  collapse_ignored_factors(cell);
  resolve_lights(cell);
  return cell;
}

void check_size(const RenderOptions& options, const Cell& cell) {
  const auto pixels = static_cast<size_t>(cell.settings.width) * static_cast<size_t>(cell.settings.height);
  if (!options.out.ends_with(".png") || pixels <= max_png_pixels) return;
  throw RequestError(
      fmt::format("--width {} --height {}: too large for a PNG file, which holds {} pixels here",
                  cell.settings.width, cell.settings.height, max_png_pixels));
}

double render_frames(RenderJob& job, int frames, bool quiet) {
  RenderWatch watch(job.item_count() * static_cast<size_t>(frames), quiet);
  job.count_items_in(&watch.done());
  const double begin = now_seconds();
  for (int i = 0; i < frames; ++i) job.frame();
  const double seconds = now_seconds() - begin;
  job.count_items_in(nullptr);
  return seconds;
}

int run(const RenderOptions& options, bool json) {
  check_out(options.out);
  check_trace(options);
  check_tolerance(options);
  const Topology topology = this_topology();
  const int pus = topology.processors();
  std::optional<ChosenMethod> chosen;
  const Cell cell = make_cell(options, topology, chosen);
  check_size(options, cell);
  std::optional<ExrPicture> reference;
  if (!options.reference.empty()) reference = read_reference(options, cell);
  if (cell.threads > pus)
    fmt::print(stderr, "note: {} threads on {} processors: oversubscribed\n", cell.threads, pus);
  RenderJob job(cell);
  if (!options.trace.empty()) job.reset(LogDetail::events);
  RenderOutcome outcome{options.out, options.frames, render_frames(job, options.frames, json), {}, chosen};
  if (!options.trace.empty()) write_trace(cell, job, options.trace);
  const bool exr = options.out.ends_with(".exr");
  const std::vector<uint32_t> ids = exr || reference ? job.hit_ids() : std::vector<uint32_t>();
  if (reference) outcome.difference = compare(job.film(), ids, reference->film, reference->hit_ids);
  if (exr) {
    write_exr(job.film(), ids, options.out);
  } else {
    write_png(job.film(), options.out);
  }
  if (json) {
    fmt::print("{}\n", describe(cell, job, outcome).dump(1));
  } else {
    print_outcome(cell, job, outcome);
  }
  const auto bad = std::ranges::count_if(job.film().pixels(), [](const Vec3f& p) { return !all_finite(p); });
  if (bad > 0) fmt::print(stderr, "raysweep: {} pixels are not finite\n", bad);
  return bad > 0 ? exit_failed : exit_done;
}

}  // namespace

void add_render(CommandLine& line) {
  Command verb = add_verb(line, "render", "one picture, with its time, rays and hash");
  static RenderOptions options;
  verb.add_option("--mode", options.mode, "low, middle, hard or very_hard: size and effort as published");
  for (const CellFactor& factor : cell_factors()) {
    const std::string name(factor.name);
    std::string option = "--" + name;
    std::ranges::replace(option, '_', '-');
    verb.add_option_function(
        option, [name](const std::string& value) { options.factors[name] = value; },
        std::string(factor.possible));
  }
  verb.add_option("--hit-tolerance", options.hit_tolerance,
                  "of --method auto: how far a hit point may be off, as a share of the scene's size (1e-4)");
  verb.add_option("--frames", options.frames, "frames to render; times are their mean").range(1, 1000000);
  verb.add_option("--reference", options.reference, "an .exr picture of the same size to compare with");
  verb.add_option("--trace", options.trace,
                  "a timeline of all chunks, for Perfetto or chrome://tracing: .json");
  verb.add_option("--out", options.out, "the picture: .png, or .exr for its floats and hit ids").required();
  verb.callback([&line] { line.action = [&line] { return run(options, line.json); }; });
}

}  // namespace raysweep
