#include "experiments/render_job.h"

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <sstream>

#include "experiments/clock.h"
#include "schedulers/placement.h"
#include "schedulers/registry.h"
#include "tracer/scene/scenes.h"

namespace raysweep {

namespace {

/// Sets "NAME=VALUE NAME=VALUE" for the runtime, which reads it when it is loaded.
void set_environment(const std::string& variables) {
  std::istringstream in(variables);
  for (std::string word; in >> word;) {
    const size_t equals = word.find('=');
    setenv(word.substr(0, equals).c_str(), word.substr(equals + 1).c_str(), 1);
  }
}

}  // namespace

SchedulerOptions scheduler_options(const Cell& cell, const std::vector<int>& placement) {
  SchedulerOptions options{.threads = cell.threads, .processors = placement};
  if (cell.runtime != "default") options.runtime = cell.runtime;
  if (cell.wait_policy == "active") options.wait = WaitPolicy::active;
  if (cell.wait_policy == "passive") options.wait = WaitPolicy::passive;
  options.spin_count = cell.spin_count;
  return options;
}

RenderJob::RenderJob(const Cell& cell)
    : topology_(this_topology()),
      placement_(place(cell.pin, cell.threads, topology_)),
      threads_(cell.threads),
      chunk_(cell.chunk),
      longest_first_(cell.order == "lpt"),
      film_(cell.settings.width, cell.settings.height),
      items_(parse_item(cell.item).value(), cell.order, cell.settings.width, cell.settings.height),
      log_(cell.threads),
      workers_(static_cast<size_t>(cell.threads)) {
  const Scene scene = load_scene(cell.scene, cell.lights);
  scene_hash_ = raysweep::scene_hash(scene);
  const double begin = now_seconds();
  renderer_ = make_renderer(scene, cell.settings);
  build_seconds_ = now_seconds() - begin;
  set_environment(cell.environment);
  scheduler_ = make_scheduler(cell.scheduler, scheduler_options(cell, placement_));
  body_ = [this](size_t first, size_t last, int worker) { render_items(first, last, worker); };
  if (longest_first_) measure_items();
}

RenderCounts RenderJob::render_measured(size_t i, Workspace& workspace) {
  const double begin = now_seconds();
  const RenderCounts counts = renderer_->render(items_.tile(i), film_, workspace);
  const double cost = now_seconds() - begin;
  const size_t index = items_.index(i);
  item_costs_->last[index] = static_cast<float>(cost);
  item_costs_->sum[index] += cost;
  return counts;
}

void RenderJob::render_items(size_t first, size_t last, int worker) {
  RenderCounts counts;
  WorkerMemory& own = workers_[static_cast<size_t>(worker)];
  // Made by the worker itself, so that its pages are near the processor that it runs on.
  if (!own.workspace) own.workspace = renderer_->make_workspace();
  for (size_t i = first; i < last; ++i) {
    counts += item_costs_ ? render_measured(i, *own.workspace)
                          : renderer_->render(items_.tile(i), film_, *own.workspace);
  }
  own.counts += counts;
  // Relaxed: a count to look at, which orders nothing.
  if (watched_) watched_->fetch_add(last - first, std::memory_order_relaxed);
}

void RenderJob::frame() {
  if (costs_known_) items_.order_by_cost(item_costs_->last);
  scheduler_->run(items_.space(), chunk_, body_, log_);
  costs_known_ = longest_first_;
  frames_++;
}

std::vector<uint32_t> RenderJob::hit_ids() {
  const auto width = static_cast<size_t>(film_.width());
  std::vector<uint32_t> ids(film_.pixels().size());
  const Body body = [&](size_t first, size_t last, int) {
    for (size_t i = first; i < last; ++i) {
      const Tile tile = items_.tile(i);
      for (int y = tile.y; y < tile.y + tile.height; ++y) {
        for (int x = tile.x; x < tile.x + tile.width; ++x)
          ids[static_cast<size_t>(y) * width + static_cast<size_t>(x)] = renderer_->first_hit(x, y);
      }
    }
  };
  WorkerLog log(threads_);
  scheduler_->run(items_.space(), chunk_, body, log);
  return ids;
}

void RenderJob::reset(LogDetail detail) {
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  film_.fill({nan, nan, nan});
  log_ = WorkerLog(threads_, detail);
  for (WorkerMemory& worker : workers_) worker.counts = {};
  if (item_costs_) std::ranges::fill(item_costs_->sum, 0);
  frames_ = 0;
}

RenderCounts RenderJob::counts() const {
  RenderCounts sum;
  for (const WorkerMemory& worker : workers_) sum += worker.counts;
  return sum;
}

std::optional<ItemSeconds> RenderJob::item_seconds() const {
  if (!item_costs_ || frames_ == 0) return std::nullopt;
  ItemSeconds seconds;
  for (const double sum : item_costs_->sum) {
    const double mean = sum / static_cast<double>(frames_);
    seconds.sum += mean;
    seconds.max = std::max(seconds.max, mean);
  }
  return seconds;
}

}  // namespace raysweep
