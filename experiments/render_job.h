// A cell made ready to run: the only place that sees a tile and a scheduler.
#pragma once

#include <atomic>
#include <memory>
#include <vector>

#include "experiments/cell.h"
#include "schedulers/scheduler.h"
#include "tracer/render.h"

namespace raysweep {

class RenderJob {
 public:
  /// Loads the scene, builds hierarchy and scheduler. Throws SceneError or SchedulerError.
  explicit RenderJob(const Cell& cell);

  /// Renders one whole picture.
  void frame();

  /// Forgets the frames so far: their rays, their worker entries, and their pixels, which become NaN, so that
  /// no pixel that a later frame leaves out can pass for rendered.
  void reset();
  /// Counts finished items, for whoever watches from another thread; a chunk costs one atomic addition more.
  /// Null ends it.
  void count_items_in(std::atomic<size_t>* counter) { watched_ = counter; }
  [[nodiscard]] size_t item_count() const { return tiles_.size(); }

  [[nodiscard]] const Film& film() const { return film_; }
  [[nodiscard]] const WorkerLog& log() const { return log_; }
  /// Rays of all frames since the last reset.
  [[nodiscard]] RayCounts rays() const { return counts().rays; }
  /// Rays and what was left out, of all frames since the last reset.
  [[nodiscard]] RenderCounts counts() const;
  /// What the ray through each pixel's centre meets first, in row order.
  [[nodiscard]] std::vector<uint32_t> hit_ids();
  [[nodiscard]] double build_seconds() const { return build_seconds_; }

 private:
  /// A cache line of its own for each worker.
  struct alignas(128) WorkerCounts {
    RenderCounts counts;
  };

  int threads_;
  Chunk chunk_;
  Film film_;
  std::vector<Tile> tiles_;
  std::unique_ptr<const Renderer> renderer_;
  std::unique_ptr<Scheduler> scheduler_;
  WorkerLog log_;
  std::vector<WorkerCounts> counts_;
  Body body_;
  std::atomic<size_t>* watched_ = nullptr;
  double build_seconds_ = 0;
};

}  // namespace raysweep
