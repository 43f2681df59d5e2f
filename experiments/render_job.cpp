#include "experiments/render_job.h"

#include <limits>

#include "experiments/clock.h"
#include "experiments/item.h"
#include "schedulers/registry.h"
#include "tracer/scene/scenes.h"

namespace raysweep {

namespace {

std::vector<Tile> cut(const ItemShape& shape, int width, int height) {
  const bool rows = shape.kind == ItemShape::Kind::rows;
  const int tile_width = rows ? width : shape.side, tile_height = rows ? 1 : shape.side;
  std::vector<Tile> tiles;
  for (int y = 0; y < height; y += tile_height) {
    for (int x = 0; x < width; x += tile_width) {
      tiles.push_back({x, y, std::min(tile_width, width - x), std::min(tile_height, height - y)});
    }
  }
  return tiles;
}

}  // namespace

RenderJob::RenderJob(const Cell& cell)
    : threads_(cell.threads),
      chunk_(cell.chunk),
      film_(cell.settings.width, cell.settings.height),
      tiles_(cut(parse_item(cell.item).value(), cell.settings.width, cell.settings.height)),
      log_(cell.threads),
      counts_(static_cast<size_t>(cell.threads)) {
  const Scene scene = load_scene(cell.scene, cell.lights);
  const double begin = now_seconds();
  renderer_ = make_renderer(scene, cell.settings);
  build_seconds_ = now_seconds() - begin;
  scheduler_ = make_scheduler(cell.scheduler, cell.threads);
  body_ = [this](size_t first, size_t last, int worker) {
    RenderCounts counts;
    for (size_t i = first; i < last; ++i) counts += renderer_->render(tiles_[i], film_);
    counts_[static_cast<size_t>(worker)].counts += counts;
    // Relaxed: a count to look at, which orders nothing.
    if (watched_) watched_->fetch_add(last - first, std::memory_order_relaxed);
  };
}

void RenderJob::frame() { scheduler_->run({tiles_.size()}, chunk_, body_, log_); }

std::vector<uint32_t> RenderJob::hit_ids() {
  const auto width = static_cast<size_t>(film_.width());
  std::vector<uint32_t> ids(film_.pixels().size());
  const Body body = [&](size_t first, size_t last, int) {
    for (size_t i = first; i < last; ++i) {
      const Tile& tile = tiles_[i];
      for (int y = tile.y; y < tile.y + tile.height; ++y) {
        for (int x = tile.x; x < tile.x + tile.width; ++x)
          ids[static_cast<size_t>(y) * width + static_cast<size_t>(x)] = renderer_->first_hit(x, y);
      }
    }
  };
  WorkerLog log(threads_);
  scheduler_->run({tiles_.size()}, chunk_, body, log);
  return ids;
}

void RenderJob::reset() {
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  film_.fill({nan, nan, nan});
  log_ = WorkerLog(threads_);
  for (WorkerCounts& entry : counts_) entry = {};
}

RenderCounts RenderJob::counts() const {
  RenderCounts sum;
  for (const WorkerCounts& entry : counts_) sum += entry.counts;
  return sum;
}

}  // namespace raysweep
