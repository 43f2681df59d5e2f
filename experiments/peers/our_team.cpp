#include "experiments/peers/our_team.h"

#include <malloc.h>

#include <type_traits>

#include "experiments/clock.h"
#include "results/statistics/statistics.h"
#include "tracer/wide/wide_core.h"

namespace raysweep {

namespace {

/// Bytes that this process has asked of malloc and not given back; 0 where it keeps no books (sanitizers).
size_t heap_bytes() {
  const auto info = mallinfo2();
  return info.uordblks + info.hblkhd;
}

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
  void run() override {
    any_hit_ ? core_->occluded(*rays_, hits_, scratch_) : core_->closest(*rays_, hits_, scratch_);
  }
  [[nodiscard]] HitBatch hits() const override { return hits_; }

 private:
  std::string name_;
  std::shared_ptr<const Core> core_;
  const RayBatch* rays_ = nullptr;
  bool any_hit_ = false;
  HitBatch hits_{0};
  KernelScratch scratch_;
};

/// Builds a core as often as builds are timed, and keeps the last.
template <class Core>
std::shared_ptr<const Core> build(const Scene& scene, std::string_view isa, BuildCost& cost) {
  std::shared_ptr<const Core> core;
  std::vector<double> seconds;
  for (int i = 0; i < build_repeats; ++i) {
    core.reset();
    const size_t before = heap_bytes();
    const double begin = now_seconds();
    core = std::make_shared<const Core>(scene, "sah", 4, isa);
    seconds.push_back(now_seconds() - begin);
    cost.bytes = heap_bytes() - before;
  }
  cost.seconds = median(seconds);
  return core;
}

}  // namespace

OracleCore make_oracle(const Scene& scene) { return OracleCore(scene, "sah", 4); }
RobustOracleCore make_robust_oracle(const Scene& scene) { return RobustOracleCore(scene, "sah", 4); }

Team make_our_team(const Scene& scene) {
  Team team;
  BuildCost cost;
  const auto enter = [&]<class Core>(std::type_identity<Core>, std::string_view isa) {
    constexpr bool robust = Core::Method::is_watertight;
    BuildCost here;
    const auto core = build<Core>(scene, isa, here);
    if (!robust && (team.entrants.empty() || here.seconds < cost.seconds))
      cost = here;  // as for Embree, the quicker one counts
    team.entrants.push_back({std::make_unique<OurContestant<Core>>(
                                 "single " + std::string(isa) + (robust ? " robust" : ""), core),
                             true, robust});
  };
  const auto enter_both = [&]<int width>(std::integral_constant<int, width>, std::string_view isa) {
    enter(std::type_identity<WideCore<MollerTrumbore, width>>(), isa);
    enter(std::type_identity<WideCore<WoopWatertight, width>>(), isa);
  };
  for (const Isa& isa : built_isas()) {
    if (!runs_here(isa.name)) continue;
    if (isa.width == 8) enter_both(std::integral_constant<int, 8>(), isa.name);
    if (isa.width == 4 && team.entrants.empty()) enter_both(std::integral_constant<int, 4>(), isa.name);
  }
  // One hierarchy stands against both of Embree's.
  team.builds = {{"medium", cost}, {"high", cost}};
  return team;
}

}  // namespace raysweep
