#include "experiments/launch.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <set>

#include "experiments/cell_factors.h"
#include "experiments/cell_record.h"
#include "experiments/clock.h"
#include "experiments/machine/machine_state.h"
#include "experiments/render_job.h"
#include "results/statistics/statistics.h"
#include "schedulers/placement.h"
#include "schedulers/registry.h"

namespace raysweep {

namespace {

constexpr double least_warmup_seconds = 0.05;
// A frame that takes longer than this has warmed up, while it ran, what was cold when it began.
constexpr double most_warmup_seconds = 0.3;
// Logging and measuring items may take so much of a frame; where they would take more, they are off.
constexpr double affordable_share = 0.01;

/// Seconds, the planted `slowdown` included, during which all threads but this one wait.
double timed_frame(RenderJob& job, double slowdown = 0) {
  const double begin = now_seconds();
  job.frame();
  double end = now_seconds();
  const double planted_end = end + slowdown * (end - begin);
  while (end < planted_end) end = now_seconds();
  return end - begin;
}

/// "libgomp: OpenMP 201511 by gcc 12.2.0, /usr/lib/…/libgomp.so.1.0.0, build …"; empty where none is needed.
std::string library_text(const Cell& cell) {
  const std::string runtime =
      cell.runtime == "default" ? default_runtime(*find_scheduler(cell.scheduler)) : cell.runtime;
  if (runtime.empty()) return {};
  const Module& module = load_module(runtime, scheduler_options(cell, {}));
  return fmt::format("{}: {}, {}, build {}", runtime, module.version, module.library.file,
                     module.library.build_id);
}

/// What is wrong with where the workers are bound, told by each from inside; empty if nothing is.
std::string what_is_misplaced(RenderJob& job, int threads) {
  if (job.placement().empty()) return {};
  const std::vector<ProcessorSet> told = processors_of_workers(job.scheduler(), threads);
  for (size_t worker = 0; worker < told.size(); ++worker) {
    const int asked = job.placement()[worker];
    if (told[worker] == ProcessorSet{asked}) continue;
    return told[worker].empty() ? fmt::format("worker {} did not come when all were called", worker)
                                : fmt::format("worker {} may run on processors {}, and was bound to {}",
                                              worker, processor_list(told[worker]), asked);
  }
  return {};
}

/// The median time of a run that has one item a thread and nothing to do.
double empty_region_seconds(Scheduler& scheduler, int threads) {
  constexpr int most = 51;
  constexpr double budget = 0.02;  // where a region takes milliseconds, few must do
  std::vector<double> samples;
  WorkerLog log(threads);
  const Body nothing = [](size_t, size_t, int) {};
  for (double total = 0; static_cast<int>(samples.size()) < most && total < budget; total += samples.back()) {
    const double begin = now_seconds();
    scheduler.run({static_cast<size_t>(threads)}, {}, nothing, log);
    samples.push_back(now_seconds() - begin);
  }
  return median(samples);
}

/// Frames until the scheduler has settled, frames have stopped getting faster and, as far as there is hope,
/// every thread has taken part. What a frame takes then.
double warm_up(RenderJob& job, const Cell& cell, Record& record) {
  constexpr size_t more_frames_at_most = 10;  // for threads that were not there yet
  const auto least = static_cast<size_t>(find_scheduler(cell.scheduler)->warmup_runs);
  std::vector<double>& frames = record.warmup_seconds;
  double total = 0;
  size_t chunks = 0;  // of the last frame: no more workers can take part
  const auto waits_for_threads = [&] {
    const auto hoped_for = static_cast<int>(std::min(static_cast<size_t>(cell.threads), chunks));
    return job.log().workers_seen() < hoped_for && frames.size() < least + more_frames_at_most;
  };
  const auto is_cold = [&] { return total < most_warmup_seconds && !has_settled(frames); };
  while (frames.size() < least || total < least_warmup_seconds || is_cold() || waits_for_threads()) {
    const size_t before = job.log().chunks();
    frames.push_back(timed_frame(job));
    total += frames.back();
    chunks = job.log().chunks() - before;
  }
  record.warm = frames.size() == 1 || has_settled(frames);
  return frames.back();
}

/// The detail of the log that the frame can afford, and a note of what it will cost.
LogDetail choose_detail(const RenderJob& job, const Cell& cell, double frame_seconds, Record& record) {
  const auto warm_frames = static_cast<double>(record.warmup_seconds.size());
  const double entries_a_worker = static_cast<double>(job.log().entries_made()) / warm_frames / cell.threads;
  record.log_share = entries_a_worker * log_cost_of_a_chunk(LogDetail::times).count() / frame_seconds;
  if (record.log_share < affordable_share) return LogDetail::times;
  record.log_share = 0;
  return LogDetail::counts;
}

/// What each item costs, in frames of their own after the timed ones, as many as take as long: reading the
/// clock before and after each must not slow down the base of every speedup. None where it would say more of
/// the clock than of the items.
ItemSeconds measure_items(RenderJob& job, double frame_seconds, double seconds) {
  // Two readings of the clock are less than an entry of the log.
  const double reading = log_cost_of_a_chunk(LogDetail::times).count();
  if (static_cast<double>(job.item_count()) * reading > affordable_share * frame_seconds) return {};
  job.measure_items();
  job.reset();
  for (double total = 0; total == 0 || total < seconds;) total += timed_frame(job);
  return job.item_seconds().value_or(ItemSeconds{});
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

void fill_in_pictures(const RenderJob& job, Record& record) {
  const uint64_t frames = record.frame_seconds.front().size();
  const RayCounts rays = job.rays();
  record.rays = {rays.primary / frames, rays.shadow / frames, rays.reflected / frames,
                 rays.refracted / frames};
  const LeftOut left = job.counts().left_out;
  record.left_out = {left.by_depth / frames, left.by_tolerance / frames, left.by_branches / frames,
                     left.bound, left.lost_media / frames};
  if (record.reason.empty()) record.reason = what_is_wrong(job, frames);
  record.valid = record.reason.empty();
  record.build_seconds = job.build_seconds();
  record.image_hash = job.film().hash();
  record.scene_hash = job.scene_hash();
}

double seconds(std::chrono::nanoseconds t) { return std::chrono::duration<double>(t).count(); }

void fill_in_workers(const RenderJob& job, Record& record) {
  const WorkerLog& log = job.log();
  // Bound workers were asked where they are: one that got no item has its processor too.
  std::set<int> processors(job.placement().begin(), job.placement().end()), cores;
  for (const WorkerEntry& entry : log.entries()) {
    record.workers.push_back({entry.items, entry.chunks, seconds(entry.busy), seconds(entry.scheduling),
                              seconds(entry.idle), entry.processor, entry.migrations});
    if (entry.processor >= 0) processors.insert(entry.processor);
    processors.insert(entry.processors.begin(), entry.processors.end());
  }
  for (const int processor : processors) {
    if (const HardwareThread* const known = job.topology().find(processor)) cores.insert(known->core);
  }
  record.threads_seen = log.workers_seen();
  record.processors_seen = static_cast<int>(processors.size());
  record.cores_seen = static_cast<int>(cores.size());
  for (const auto& [size, times] : log.chunk_sizes()) record.chunk_sizes.emplace_back(size, times);
  record.imbalance = log.imbalance();
}

/// What the machine does from its making on.
class Surroundings {
 public:
  explicit Surroundings(const ProcessorSet& allowed)
      : allowed_(allowed), spin_before_(spin_seconds()), before_(read_state("/", allowed)) {}

  [[nodiscard]] LaunchState change() const {
    LaunchState state = change_between(before_, read_state("/", allowed_));
    state.spin_before_seconds = spin_before_;
    state.spin_after_seconds = spin_seconds();
    return state;
  }

 private:
  const ProcessorSet& allowed_;
  const double spin_before_;
  const StateCounters before_;
};

}  // namespace

bool has_settled(const std::vector<double>& frames) {
  constexpr double faster = 0.98;  // noise makes frames slower, hardly ever faster
  if (frames.size() < 2) return false;
  return frames.back() > faster * *std::min_element(frames.begin(), frames.end() - 1);
}

void run_launch(const Cell& cell, const LaunchOptions& options) {
  const ProcessorSet allowed = allowed_processors();  // before a scheduler binds this thread
  RenderJob job(cell);
  Record record = record_of(cell);
  record.library = library_text(cell);
  record.reason = what_is_misplaced(job, cell.threads);
  std::vector<double>& frames = record.frame_seconds.emplace_back();
  LogDetail detail = LogDetail::counts;
  if (options.timed) {
    record.empty_region_seconds = empty_region_seconds(job.scheduler(), cell.threads);
    const double frame_seconds = warm_up(job, cell, record);
    detail = choose_detail(job, cell, frame_seconds, record);
  }
  job.reset(detail);
  if (options.before_timing) options.before_timing();
  const Surroundings surroundings(allowed);
  double total = 0;
  uint64_t chunks = 0;
  do {
    frames.push_back(timed_frame(job, cell.slowdown));
    total += frames.back();
    record.chunks_made.push_back(job.log().chunks() - chunks);
    chunks += record.chunks_made.back();
  } while (options.timed && total < options.seconds);
  if (options.timed) record.state = surroundings.change();
  fill_in_pictures(job, record);
  fill_in_workers(job, record);
  const bool alone = !options.keep_busy;  // co-running copies are asked for their pace only
  if (options.timed && alone && cell.scheduler == "serial")
    record.item_seconds = measure_items(job, total / static_cast<double>(frames.size()), options.seconds);
  options.report(record);
  while (options.keep_busy && options.keep_busy()) job.frame();
}

}  // namespace raysweep
