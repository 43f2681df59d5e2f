#include "experiments/peers/picture_maker.h"

#include <cmath>
#include <limits>

#include "experiments/clock.h"
#include "experiments/peers/shared_work.h"

namespace raysweep {

namespace {

size_t tiles_along(int length) { return static_cast<size_t>((length + picture_tile - 1) / picture_tile); }

}  // namespace

PictureMaker::PictureMaker(std::unique_ptr<const Renderer> renderer, int width, int height, int threads)
    : renderer_(std::move(renderer)), film_(width, height) {
  for (int i = 0; i < threads; ++i) workspaces_.push_back(renderer_->make_workspace());
}

size_t PictureMaker::tile_count() const { return tiles_along(film_.width()) * tiles_along(film_.height()); }

Tile PictureMaker::tile(size_t index) const {
  const size_t columns = tiles_along(film_.width());
  const int x = static_cast<int>(index % columns) * picture_tile;
  const int y = static_cast<int>(index / columns) * picture_tile;
  return {x, y, std::min(picture_tile, film_.width() - x), std::min(picture_tile, film_.height() - y)};
}

double PictureMaker::run(size_t stride) {
  const size_t count = (tile_count() + stride - 1) / stride;
  const double begin = now_seconds();
  share_work(static_cast<int>(workspaces_.size()), count, [&](size_t i, size_t worker) {
    (void)renderer_->render(tile(i * stride), film_, *workspaces_[worker]);
  });
  return now_seconds() - begin;
}

PixelDifferences pixel_differences(const Film& a, const Film& b) {
  PixelDifferences found;
  for (size_t i = 0; i < a.pixels().size(); ++i) {
    const Vec3d of_a(a.pixels()[i]), of_b(b.pixels()[i]);
    double largest = 0;
    for (const int channel : {0, 1, 2}) {
      const double difference = std::abs(of_a[channel] - of_b[channel]);
      if (std::isnan(of_a[channel]) && std::isnan(of_b[channel])) continue;
      largest =
          std::max(largest, std::isnan(difference) ? std::numeric_limits<double>::infinity() : difference);
    }
    found.pixels += largest > 0;
    found.largest = std::max(found.largest, largest);
  }
  return found;
}

}  // namespace raysweep
