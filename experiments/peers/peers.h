// Our tracer against Embree on the same rays: what was asked, and what came out.
#pragma once

#include <functional>

#include "experiments/peers/duel.h"
#include "experiments/peers/embree_team.h"
#include "experiments/peers/pictures.h"
#include "experiments/peers/rays.h"
#include "results/statistics/statistics.h"

namespace raysweep {

struct PeersRequest {
  std::vector<std::string> scenes;  // names or files
  int width = 1024, height = 768;
  std::vector<RayKind> kinds{RayKind::primary, RayKind::shadow, RayKind::mirror, RayKind::diffuse};
  DuelOptions duel;
  PicturesRequest pictures;
};

/// The best of ours against the best of Embree's in one class, on rays of one kind.
struct PeersRow {
  std::string scene;
  size_t triangles = 0, rays = 0;
  RayKind kind{};
  DuelClass duel_class{};
  std::string ours, embree;                           // names of the contestants
  double ours_per_second = 0, embree_per_second = 0;  // rays, medians over the rounds
  Estimate ratio;                                     // ours / Embree's, median of the rounds' ratios
  HitDifferences between, ours_from_oracle, embree_from_oracle;
};

struct PeersBuild {
  std::string scene;
  size_t triangles = 0;
  std::string build_class;
  int threads = 1;
  BuildCost ours, embree;  // medians over the rounds
  Estimate ratio;          // of times, ours / Embree's, median of the rounds' ratios
};

struct PeersResult {
  std::vector<PeersRow> rows;
  std::vector<PeersBuild> builds;
  std::vector<PictureRow> pictures;
  std::vector<std::string> left_out;  // kinds without rays and scenes without pictures, as sentences
};

/// The row of `duel_class`, from a duel on `rays`; none where one of the two did not enter. Runs both once
/// more, for their hits.
[[nodiscard]] std::optional<PeersRow> make_row(std::span<const Performance> all, DuelClass duel_class,
                                               const RayBatch& rays, bool any_hit);

/// Times the builds of both teams of one class and so many threads in rounds, all in each; none where one of
/// the teams has no such build.
[[nodiscard]] std::optional<PeersBuild> compare_builds(const Team& ours, const Team& embree,
                                                       const std::string& build_class, int threads);

/// Throws SceneError and RequestError before anything runs. `say` is told what comes next.
[[nodiscard]] PeersResult compare_with_embree(const PeersRequest& request, const EmbreeModule& embree,
                                              const std::function<void(const std::string&)>& say);

}  // namespace raysweep
