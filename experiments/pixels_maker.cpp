#include "experiments/pixels_maker.h"

#include <algorithm>

#include "experiments/clock.h"
#include "experiments/peers/picture_maker.h"
#include "experiments/picture_edges.h"
#include "tracer/compare.h"

namespace raysweep {

PixelsMaker::PixelsMaker(const Scene& scene, const RenderSettings& settings)
    : renderer_(make_renderer(scene, settings)),
      workspace_(renderer_->make_workspace()),
      film_(settings.width, settings.height) {
  (void)frame();
}

double PixelsMaker::frame() {
  const double begin = now_seconds();
  RenderCounts counts;
  for (int y = 0; y < film_.height(); y += picture_tile) {
    for (int x = 0; x < film_.width(); x += picture_tile) {
      const Tile tile{x, y, std::min(picture_tile, film_.width() - x),
                      std::min(picture_tile, film_.height() - y)};
      counts += renderer_->render(tile, film_, *workspace_);
    }
  }
  ray_count_ = counts.rays.total();
  return now_seconds() - begin;
}

std::vector<uint32_t> PixelsMaker::hit_ids() const {
  std::vector<uint32_t> ids;
  for (int y = 0; y < film_.height(); ++y) {
    for (int x = 0; x < film_.width(); ++x) ids.push_back(renderer_->first_hit(x, y));
  }
  return ids;
}

void tell_errors(PixelsRecord& record, const PixelsMaker& maker, const PixelsMaker& reference,
                 const FlipMap& map) {
  const Film& film = maker.film();
  const PictureDifference difference = compare(film, maker.hit_ids(), reference.film(), reference.hit_ids());
  record.width = film.width();
  record.height = film.height();
  record.pixels = film.pixels().size();
  record.wrong_pixels = difference.wrong_pixels;
  record.hole_pixels = difference.holes;
  record.nonfinite_pixels = difference.non_finite;
  record.flip_mean = map.mean();
  record.flip_p95 = map.quantile(0.95);
  record.flip_max = map.max();
  record.max_difference = difference.max_8bit;
  record.rmse = difference.rmse;
  const EdgeError at_edges = error_at_edges(film, reference.film());
  record.edge_pixels = at_edges.pixels;
  record.edge_rmse = at_edges.rmse;
  record.rays = maker.ray_count();
}

}  // namespace raysweep
