#include "experiments/render_report.h"

#include <fmt/core.h>
#include <sys/resource.h>

#include <nlohmann/json.hpp>

#include "experiments/picture_report.h"
#include "experiments/worker_report.h"
#include "tracer/shade/medium_set.h"

namespace raysweep {

namespace {

/// The most memory that this process ever held.
uint64_t peak_memory_bytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<uint64_t>(usage.ru_maxrss) * 1024;  // Linux counts in KiB
}

RenderCounts of_one_frame(RenderCounts counts, int frames) {
  const auto n = static_cast<uint64_t>(frames);
  for (uint64_t* count : {&counts.rays.primary, &counts.rays.shadow, &counts.rays.reflected,
                          &counts.rays.refracted, &counts.left_out.by_depth, &counts.left_out.by_tolerance,
                          &counts.left_out.by_branches, &counts.left_out.lost_media}) {
    *count /= n;
  }
  return counts;
}

double mrays_per_second(const RenderJob& job, double seconds) {
  return static_cast<double>(job.rays().total()) / seconds / 1e6;
}

void print_left_out(const LeftOut& left_out, uint64_t ray_count) {
  if (left_out.by_depth > 0)
    fmt::print("depth limit: {} rays not sent; they count as black\n", left_out.by_depth);
  if (left_out.by_tolerance + left_out.by_branches > 0) {
    fmt::print(
        "left out: {} rays by the pixel tolerance, {} by the limit of rays a sample; no channel of any "
        "sample lacks more than {:.2g}\n",
        left_out.by_tolerance, left_out.by_branches, left_out.bound);
  }
  if (left_out.lost_media > 0) {
    fmt::print(
        "note: {} of {} rays lost track of what they were in: a few per hundred million slip between "
        "triangles; "
        "more come from media nested more than {} deep or meshes that cut through themselves\n",
        left_out.lost_media, ray_count, MediumSet::capacity);
  }
}

}  // namespace

nlohmann::json describe(const Cell& cell, const RenderJob& job, const RenderOutcome& outcome) {
  const auto [rays, left_out] = of_one_frame(job.counts(), outcome.frames);
  nlohmann::json json{{"image_hash", job.film().hash()},
                      {"seconds", outcome.seconds / outcome.frames},
                      {"fps", outcome.frames / outcome.seconds},
                      {"frames", outcome.frames},
                      {"width", cell.settings.width},
                      {"height", cell.settings.height},
                      {"rays",
                       {{"primary", rays.primary},
                        {"shadow", rays.shadow},
                        {"reflected", rays.reflected},
                        {"refracted", rays.refracted}}},
                      {"left_out",
                       {{"by_depth", left_out.by_depth},
                        {"by_tolerance", left_out.by_tolerance},
                        {"by_branches", left_out.by_branches},
                        {"bound", left_out.bound},
                        {"lost_media", left_out.lost_media}}},
                      {"mrays_per_second", mrays_per_second(job, outcome.seconds)},
                      {"build_seconds", job.build_seconds()},
                      {"peak_memory_bytes", peak_memory_bytes()},
                      {"cell", cell.key()},
                      {"threads", cell.threads},
                      {"threads_seen", job.log().workers_seen()}};
  if (job.log().detail() != LogDetail::counts) json["workers"] = workers_as_json(job.log());
  if (outcome.difference) json["difference"] = to_json(*outcome.difference);
  if (outcome.chosen) {
    json["chosen"] = {{"method", cell.settings.method},
                      {"precision", cell.settings.precision},
                      {"predicted", outcome.chosen->bound},
                      {"hit_tolerance", outcome.chosen->tolerance}};
  }
  return json;
}

void print_outcome(const Cell& cell, const RenderJob& job, const RenderOutcome& outcome) {
  const auto [rays, left_out] = of_one_frame(job.counts(), outcome.frames);
  if (outcome.chosen) {
    fmt::print(
        "method {} in {}: the cheapest that can promise hit points within {} of the scene's size; it "
        "promises "
        "{:.1e}\n",
        cell.settings.method, cell.settings.precision, outcome.chosen->tolerance, outcome.chosen->bound);
  }
  fmt::print("{}: {} × {}, {:.3f} s a frame ({:.3g} fps) by {} on {} of {} threads\n", outcome.out,
             cell.settings.width, cell.settings.height, outcome.seconds / outcome.frames,
             outcome.frames / outcome.seconds, cell.scheduler, job.log().workers_seen(), cell.threads);
  fmt::print("rays: {} primary, {} shadow, {} reflected, {} refracted; {:.2f} Mrays/s\n", rays.primary,
             rays.shadow, rays.reflected, rays.refracted, mrays_per_second(job, outcome.seconds));
  fmt::print("built in {:.3f} s; at most {:.0f} MB of memory\n", job.build_seconds(),
             static_cast<double>(peak_memory_bytes()) / 1e6);
  print_left_out(left_out, rays.primary + rays.reflected + rays.refracted);
  if (outcome.difference) fmt::print("against the reference: {}\n", to_text(*outcome.difference));
  if (job.log().detail() != LogDetail::counts) fmt::print("{}", to_text(worker_table(job.log())));
  fmt::print("picture {}\n", job.film().hash());
}

}  // namespace raysweep
