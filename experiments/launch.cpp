#include "experiments/launch.h"

#include <fmt/format.h>

#include <algorithm>

#include "experiments/cell_record.h"
#include "experiments/clock.h"
#include "experiments/render_job.h"
#include "schedulers/registry.h"

namespace raysweep {

namespace {

constexpr double warmup_seconds = 0.05;

double timed_frame(RenderJob& job) {
  const double begin = now_seconds();
  job.frame();
  return now_seconds() - begin;
}

uint64_t chunks_so_far(const RenderJob& job) {
  uint64_t sum = 0;
  for (const WorkerEntry& entry : job.log().entries()) sum += entry.chunks;
  return sum;
}

void warm_up(RenderJob& job, int frames, Record& record) {
  double total = 0;
  while (static_cast<int>(record.warmup_seconds.size()) < frames || total < warmup_seconds) {
    record.warmup_seconds.push_back(timed_frame(job));
    total += record.warmup_seconds.back();
  }
}

/// Every timed frame must have run every item, and sent out the same rays.
std::string what_is_wrong(const RenderJob& job, uint64_t frames) {
  uint64_t items = 0;
  for (const WorkerEntry& entry : job.log().entries()) items += entry.items;
  const RayCounts rays = job.rays();
  if (items != frames * job.item_count()) {
    return fmt::format("{} items ran in {} frames of {}", items, frames, job.item_count());
  }
  if (rays.primary % frames + rays.shadow % frames + rays.reflected % frames + rays.refracted % frames != 0)
    return "frames differ in their rays";
  return {};
}

void fill_in(const RenderJob& job, Record& record) {
  const uint64_t frames = record.frame_seconds.front().size();
  const RayCounts rays = job.rays();
  record.rays = {rays.primary / frames, rays.shadow / frames, rays.reflected / frames,
                 rays.refracted / frames};
  const LeftOut left = job.counts().left_out;
  record.left_out = {left.by_depth / frames, left.by_tolerance / frames, left.by_branches / frames,
                     left.bound, left.lost_media / frames};
  record.reason = what_is_wrong(job, frames);
  record.valid = record.reason.empty();
  record.build_seconds = job.build_seconds();
  record.image_hash = job.film().hash();
  record.threads_seen = job.log().workers_seen();
  for (const WorkerEntry& entry : job.log().entries()) {
    record.workers.push_back({entry.items, entry.chunks, entry.processor});
  }
}

}  // namespace

void run_launch(const Cell& cell, const LaunchOptions& options) {
  RenderJob job(cell);
  Record record = record_of(cell);
  record.runtime = runtime_of(find_scheduler(cell.scheduler)->family);
  std::vector<double>& frames = record.frame_seconds.emplace_back();
  if (options.timed) warm_up(job, find_scheduler(cell.scheduler)->warmup_runs, record);
  job.reset();
  if (options.before_timing) options.before_timing();
  double total = 0;
  uint64_t chunks = 0;
  do {
    frames.push_back(timed_frame(job));
    total += frames.back();
    record.chunks_made.push_back(chunks_so_far(job) - chunks);
    chunks += record.chunks_made.back();
  } while (options.timed && total < options.seconds);
  fill_in(job, record);
  options.report(record);
  while (options.keep_busy && options.keep_busy()) job.frame();
}

}  // namespace raysweep
