#include "experiments/peers/our_team.h"

#include <malloc.h>

#include <optional>

#include "experiments/clock.h"
#include "results/statistics/statistics.h"

namespace raysweep {

namespace {

/// Bytes that this process has asked of malloc and not given back; 0 where it keeps no books (sanitizers).
size_t heap_bytes() {
  const auto info = mallinfo2();
  return info.uordblks + info.hblkhd;
}

/// A core that answers one ray at a time, as one that answers batches.
class OneByOne {
 public:
  explicit OneByOne(const Scene& scene) : core_(make_oracle(scene)) {}

  void closest(const RayBatch& rays, HitBatch& hits) const {
    for (size_t i = 0; i < rays.size; ++i) {
      const auto hit = core_.closest(rays.ray(i), Hit<float>::start(), rays.t_max[i]);
      hits.t[i] = hit ? hit->t : rays.t_max[i];
      hits.id[i] = hit ? hit->id : no_hit_id;
    }
  }

  void occluded(const RayBatch& rays, HitBatch& hits) const {
    const uint32_t any = core_.primitives().first_triangle();
    for (size_t i = 0; i < rays.size; ++i)
      hits.id[i] = core_.occluded(rays.ray(i), rays.t_max[i]) ? any : no_hit_id;
  }

 private:
  OracleCore core_;
};

/// `Core` has `closest` and `occluded` of batches; several contestants may share one.
template <class Core>
class OurContestant final : public Contestant {
 public:
  OurContestant(std::string name, std::shared_ptr<const Core> core)
      : name_(std::move(name)), core_(std::move(core)) {}

  [[nodiscard]] std::string name() const override { return name_; }
  void prepare(const RayBatch& rays, bool any_hit) override {
    rays_ = &rays;
    any_hit_ = any_hit;
    hits_ = HitBatch(rays.size);
  }
  void reset() override {}  // rays are only read
  void run() override { any_hit_ ? core_->occluded(*rays_, hits_) : core_->closest(*rays_, hits_); }
  [[nodiscard]] HitBatch hits() const override { return hits_; }

 private:
  std::string name_;
  std::shared_ptr<const Core> core_;
  const RayBatch* rays_ = nullptr;
  bool any_hit_ = false;
  HitBatch hits_{0};
};

/// Builds a core as often as builds are timed, and keeps the last.
template <class Core>
std::shared_ptr<const Core> build(const Scene& scene, BuildCost& cost) {
  std::shared_ptr<const Core> core;
  std::vector<double> seconds;
  for (int i = 0; i < build_repeats; ++i) {
    core.reset();
    const size_t before = heap_bytes();
    const double begin = now_seconds();
    core = std::make_shared<const Core>(scene);
    seconds.push_back(now_seconds() - begin);
    cost.bytes = heap_bytes() - before;
  }
  cost.seconds = median(seconds);
  return core;
}

}  // namespace

OracleCore make_oracle(const Scene& scene) { return OracleCore(scene, "sah", 4); }

Team make_our_team(const Scene& scene) {
  Team team;
  BuildCost cost;
  const auto scalar = build<OneByOne>(scene, cost);
  team.entrants.push_back({std::make_unique<OurContestant<OneByOne>>("scalar", scalar), true, false});
  // One hierarchy stands against both of Embree's.
  team.builds = {{"medium", cost}, {"high", cost}};
  return team;
}

}  // namespace raysweep
