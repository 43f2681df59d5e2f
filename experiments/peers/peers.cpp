#include "experiments/peers/peers.h"

#include <fmt/format.h>

#include <algorithm>

#include "experiments/errors.h"
#include "tracer/scene/scenes.h"

namespace raysweep {

namespace {

struct NamedScene {
  std::string name;
  Scene scene;
};

std::vector<NamedScene> load_all(const std::vector<std::string>& names) {
  std::vector<NamedScene> scenes;
  for (const std::string& name : names) {
    scenes.push_back({name, triangles_alone(load_scene(name))});
    if (scenes.back().scene.triangle_count() == 0) {
      throw RequestError(fmt::format(
          "scene \"{}\" has no triangles, and peers compares triangles alone: name one with a mesh, "
          "such as chair-ball",
          name));
    }
  }
  return scenes;
}

/// One build and what it took in each round.
struct BuildRounds {
  const TimedBuild* build;
  std::vector<double> seconds;
  size_t bytes = 0;

  void run() {
    const BuildCost cost = build->run();
    seconds.push_back(cost.seconds);
    bytes = cost.bytes;
  }
  [[nodiscard]] BuildCost cost() const { return {median(seconds), bytes}; }
};

std::vector<BuildRounds> builds_of(const Team& team, const std::string& build_class, int threads) {
  std::vector<BuildRounds> builds;
  for (const TimedBuild& build : team.builds)
    if (build.build_class == build_class && build.threads == threads) builds.push_back({&build, {}});
  return builds;
}

const BuildRounds& quickest(const std::vector<BuildRounds>& builds) {
  return *std::ranges::min_element(builds, {}, [](const BuildRounds& b) { return b.cost().seconds; });
}

/// Of `contestant`'s, alone.
HitBatch hits_of(Contestant& contestant) {
  contestant.reset();
  contestant.run();
  return contestant.hits();
}

template <class Core>
HitBatch oracle_hits(const Core& core, const RayBatch& rays, bool any_hit) {
  HitBatch hits(rays.size);
  for (size_t i = 0; i < rays.size; ++i) {
    hits.t[i] = rays.t_max[i];
    if (any_hit) {
      if (core.occluded(rays.ray(i), rays.t_max[i])) hits.id[i] = core.primitives().first_triangle();
    } else if (const auto hit = core.closest(rays.ray(i), Hit<float>::start(), rays.t_max[i])) {
      hits.t[i] = hit->t;
      hits.id[i] = hit->id;
    }
  }
  return hits;
}

/// One scene's part of the work.
class SceneComparison {
 public:
  SceneComparison(const NamedScene& scene, const PeersRequest& request, const EmbreeModule& embree)
      : scene_(scene),
        request_(request),
        oracle_(make_oracle(scene.scene)),
        robust_oracle_(make_robust_oracle(scene.scene)),
        ours_(make_our_team(scene.scene, embree.share_by_tbb)),
        embree_(embree.make_team(scene.scene, is_robust(ours_))) {}

  void add_builds(PeersResult& result) const {
    for (const char* build_class : {"medium", "high"}) {
      for (const int threads : build_threads) {
        auto build = compare_builds(ours_, embree_, build_class, threads);
        if (!build) continue;
        build->scene = scene_.name;
        build->triangles = scene_.scene.triangle_count();
        result.builds.push_back(std::move(*build));
      }
    }
  }

  void add_rows(RayKind kind, PeersResult& result) const {
    const RayBatch rays =
        make_rays(kind, scene_.scene, oracle_, request_.width, request_.height, request_.duel.seed);
    if (rays.size == 0) {
      result.left_out.push_back(fmt::format("{}: no {} rays: nothing to start them at", scene_.name,
                                            ray_kind_names[static_cast<size_t>(kind)]));
      return;
    }
    const bool any_hit = asks_any_hit(kind);
    const OracleHits oracle{oracle_hits(oracle_, rays, any_hit), oracle_hits(robust_oracle_, rays, any_hit)};
    const auto all = duel(ours_, embree_, rays, any_hit, oracle, request_.duel);
    for (const DuelClass c : {DuelClass::single, DuelClass::best, DuelClass::robust}) {
      auto row = make_row(all, c, rays, any_hit);
      if (!row) continue;
      row->scene = scene_.name;
      row->triangles = scene_.scene.triangle_count();
      row->kind = kind;
      result.rows.push_back(std::move(*row));
    }
  }

 private:
  static bool is_robust(const Team& team) { return std::ranges::any_of(team.entrants, &Entrant::robust); }

  const NamedScene& scene_;
  const PeersRequest& request_;
  OracleCore oracle_;
  RobustOracleCore robust_oracle_;
  Team ours_, embree_;
};

/// The whole scene's pictures, planes and spheres included.
void add_pictures(const std::string& name, const PeersRequest& request, const EmbreeModule& embree,
                  const std::function<void(const std::string&)>& say, PeersResult& result) {
  if (request.pictures.modes.empty()) return;
  if (has_transparency(load_scene(name))) {
    result.left_out.push_back(
        fmt::format("{}: no pictures: it holds glass, and those with Embree are of opaque scenes", name));
    return;
  }
  say(fmt::format("{}: building for pictures", name));
  const auto theirs = embree.make_pictures(load_scene(name));
  for (const std::string& mode : request.pictures.modes) {
    say(fmt::format("{}: pictures, {}", name, mode));
    for (PictureRow& row : compare_pictures(name, mode, request.pictures, *theirs))
      result.pictures.push_back(std::move(row));
  }
}

}  // namespace

std::optional<PeersRow> make_row(std::span<const Performance> all, DuelClass duel_class, const RayBatch& rays,
                                 bool any_hit) {
  const Performance* const ours = best_of(all, true, duel_class);
  const Performance* const embree = best_of(all, false, duel_class);
  if (!ours || !embree) return std::nullopt;
  std::vector<double> ratios;
  for (size_t round = 0; round < ours->rounds.size(); ++round)
    ratios.push_back(ours->rounds[round] / embree->rounds[round]);
  PeersRow row;
  row.rays = rays.size;
  row.duel_class = duel_class;
  row.ours = ours->entrant->contestant->name();
  row.embree = embree->entrant->contestant->name();
  row.ours_per_second = median(ours->rounds);
  row.embree_per_second = median(embree->rounds);
  row.ratio = estimate_median(std::move(ratios));
  row.between = differences(hits_of(*ours->entrant->contestant), hits_of(*embree->entrant->contestant),
                            rays.size, any_hit);
  row.ours_from_oracle = ours->from_oracle;
  row.embree_from_oracle = embree->from_oracle;
  return row;
}

std::optional<PeersBuild> compare_builds(const Team& ours, const Team& embree, const std::string& build_class,
                                         int threads) {
  std::vector<BuildRounds> mine = builds_of(ours, build_class, threads);
  std::vector<BuildRounds> theirs = builds_of(embree, build_class, threads);
  if (mine.empty() || theirs.empty()) return std::nullopt;
  for (int round = 0; round < build_rounds; ++round) {
    for (auto* team : {&mine, &theirs})
      for (BuildRounds& build : *team) build.run();
  }
  const BuildRounds &best = quickest(mine), &other = quickest(theirs);
  std::vector<double> ratios;
  for (size_t i = 0; i < best.seconds.size(); ++i) ratios.push_back(best.seconds[i] / other.seconds[i]);
  PeersBuild result;
  result.build_class = build_class;
  result.threads = threads;
  result.ours = best.cost();
  result.embree = other.cost();
  result.ratio = estimate_median(std::move(ratios));
  return result;
}

PeersResult compare_with_embree(const PeersRequest& request, const EmbreeModule& embree,
                                const std::function<void(const std::string&)>& say) {
  const std::vector<NamedScene> scenes = load_all(request.scenes);
  PeersResult result;
  for (const NamedScene& scene : scenes) {
    say(fmt::format("{}: building", scene.name));
    const SceneComparison comparison(scene, request, embree);
    comparison.add_builds(result);
    for (const RayKind kind : request.kinds) {
      say(fmt::format("{}: {} rays", scene.name, ray_kind_names[static_cast<size_t>(kind)]));
      comparison.add_rows(kind, result);
    }
  }
  // After all rays: what those were traced in is gone by then.
  for (const NamedScene& scene : scenes) add_pictures(scene.name, request, embree, say, result);
  return result;
}

}  // namespace raysweep
