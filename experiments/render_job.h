// A cell made ready to run: the only place that sees a tile and a scheduler.
#pragma once

#include <atomic>
#include <memory>
#include <optional>
#include <vector>

#include "experiments/cell.h"
#include "experiments/item.h"
#include "results/record.h"
#include "schedulers/options.h"
#include "schedulers/scheduler.h"
#include "schedulers/topology.h"
#include "tracer/render.h"

namespace raysweep {

/// The cell's scheduler, with its workers at `placement`.
[[nodiscard]] SchedulerOptions scheduler_options(const Cell& cell, const std::vector<int>& placement);

class RenderJob {
 public:
  /// Loads the scene, builds hierarchy and scheduler, the latter with the cell's environment. Throws
  /// SceneError or SchedulerError.
  explicit RenderJob(const Cell& cell);

  /// Renders one whole picture.
  void frame();

  /// Forgets the frames so far: their rays, their worker entries, and their pixels, which become NaN, so that
  /// no pixel that a later frame leaves out can pass for rendered.
  /// From here on workers are logged in `detail`.
  void reset(LogDetail detail = LogDetail::counts);
  /// Reads the clock before and after each item from now on: for `item_seconds`. With the order "lpt" it does
  /// anyway.
  void measure_items() { item_costs_.emplace(items_.count()); }
  /// Counts finished items, for whoever watches from another thread; a chunk costs one atomic addition more.
  /// Null ends it.
  void count_items_in(std::atomic<size_t>* counter) { watched_ = counter; }
  [[nodiscard]] size_t item_count() const { return items_.count(); }

  [[nodiscard]] const Film& film() const { return film_; }
  [[nodiscard]] const WorkerLog& log() const { return log_; }
  /// Rays of all frames since the last reset.
  [[nodiscard]] RayCounts rays() const { return counts().rays; }
  /// Rays and what was left out, of all frames since the last reset.
  [[nodiscard]] RenderCounts counts() const;
  /// What the ray through each pixel's centre meets first, in row order.
  [[nodiscard]] std::vector<uint32_t> hit_ids();
  [[nodiscard]] double build_seconds() const { return build_seconds_; }
  [[nodiscard]] const std::string& scene_hash() const { return scene_hash_; }
  /// What the items of a frame cost, by their mean over the frames since the last reset; none if not
  /// measured.
  [[nodiscard]] std::optional<ItemSeconds> item_seconds() const;
  /// The processors where the cell's pin has put each worker; empty for "none".
  [[nodiscard]] const std::vector<int>& placement() const { return placement_; }
  [[nodiscard]] const Topology& topology() const { return topology_; }
  [[nodiscard]] Scheduler& scheduler() { return *scheduler_; }

 private:
  /// A cache line of its own for each worker.
  struct alignas(128) WorkerMemory {
    RenderCounts counts;
    std::unique_ptr<Workspace> workspace;  // made with the worker's first item
  };

  void render_items(size_t first, size_t last, int worker);
  RenderCounts render_measured(size_t i, Workspace& workspace);

  /// By scanline index: the last frame's costs, and the sum over frames.
  struct ItemCosts {
    explicit ItemCosts(size_t count) : last(count), sum(count) {}
    std::vector<float> last;
    std::vector<double> sum;
  };

  const Topology topology_;
  const std::vector<int> placement_;
  int threads_;
  Chunk chunk_;
  bool longest_first_;
  Film film_;
  Items items_;
  std::optional<ItemCosts> item_costs_;
  bool costs_known_ = false;  // for the order "lpt": a frame has told them
  uint64_t frames_ = 0;       // since the last reset
  std::unique_ptr<const Renderer> renderer_;
  std::unique_ptr<Scheduler> scheduler_;
  WorkerLog log_;
  std::vector<WorkerMemory> workers_;
  Body body_;
  std::atomic<size_t>* watched_ = nullptr;
  double build_seconds_ = 0;
  std::string scene_hash_;
};

}  // namespace raysweep
