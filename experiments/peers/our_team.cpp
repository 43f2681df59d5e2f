#include "experiments/peers/our_team.h"

#include <malloc.h>

#include <type_traits>

#include "experiments/clock.h"
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
  OurContestant(std::shared_ptr<const Core> core, std::string_view isa, bool high_quality, Grouping grouping)
      : core_(std::move(core)), isa_(isa), high_quality_(high_quality), grouping_(grouping) {}

  /// "packets avx512 high robust"
  [[nodiscard]] std::string name() const override {
    return (grouping_ == Grouping::packets ? "packets " : "single ") + isa_ + (high_quality_ ? " high" : "") +
           (Core::Method::is_watertight ? " robust" : "");
  }
  void prepare(const RayBatch& rays, bool any_hit) override {
    rays_ = &rays;
    any_hit_ = any_hit;
    hits_ = HitBatch(rays.size);
  }
  void reset() override {}  // rays are only read
  void run() override {
    if (any_hit_) {
      core_->occluded(*rays_, hits_, scratch_, grouping_);
    } else {
      core_->closest(*rays_, hits_, scratch_, grouping_);
    }
  }
  [[nodiscard]] HitBatch hits() const override { return hits_; }

 private:
  std::shared_ptr<const Core> core_;
  std::string isa_;
  bool high_quality_;
  Grouping grouping_;
  const RayBatch* rays_ = nullptr;
  bool any_hit_ = false;
  HitBatch hits_{0};
  KernelScratch scratch_;
};

/// What stands against each of Embree's: its builder of high quality cuts triangles in two as well.
const char* accel_of(bool high_quality) { return high_quality ? "sbvh" : "sah"; }

template <class Core>
BuildCost timed_build(const Scene& scene, bool high_quality, std::string_view isa, const ForEach& for_each) {
  const size_t before = heap_bytes();
  const double begin = now_seconds();
  const Core core(scene, accel_of(high_quality), 4, isa, for_each);
  return {now_seconds() - begin, heap_bytes() - before};
}

template <class Core>
void add_builds(Team& team, const Scene& scene, std::string_view isa, ShareWork share) {
  for (const bool high : {false, true}) {
    for (const int threads : build_threads)
      team.builds.push_back({high ? "high" : "medium", threads, [&scene, high, isa, threads, share] {
                               // Made before, as is a device of Embree's with its threads.
                               return timed_build<Core>(scene, high, isa,
                                                        threads == 1 ? one_after_the_other : share(threads));
                             }});
  }
}

}  // namespace

OracleCore make_oracle(const Scene& scene) { return OracleCore(scene, "sah", 4); }
RobustOracleCore make_robust_oracle(const Scene& scene) { return RobustOracleCore(scene, "sah", 4); }

Team make_our_team(const Scene& scene, ShareWork share) {
  Team team;
  const auto enter = [&]<class Core>(std::type_identity<Core>, std::string_view isa) {
    constexpr bool robust = Core::Method::is_watertight;
    for (const bool high : {false, true}) {
      const auto core = std::make_shared<const Core>(scene, accel_of(high), 4, isa);
      for (const Grouping grouping : {Grouping::single, Grouping::packets})
        team.entrants.push_back({std::make_unique<OurContestant<Core>>(core, isa, high, grouping),
                                 grouping == Grouping::single && !high, robust});
    }
  };
  const auto enter_both = [&]<int width>(std::integral_constant<int, width>, std::string_view isa) {
    // Which instructions traverse a hierarchy later does not matter to its building.
    if (team.builds.empty()) add_builds<WideCore<MollerTrumbore, width>>(team, scene, isa, share);
    enter(std::type_identity<WideCore<MollerTrumbore, width>>(), isa);
    enter(std::type_identity<WideCore<WoopWatertight, width>>(), isa);
  };
  for (const Isa& isa : built_isas()) {
    if (!runs_here(isa.name)) continue;
    if (isa.width == 8) enter_both(std::integral_constant<int, 8>(), isa.name);
    if (isa.width == 4 && team.entrants.empty()) enter_both(std::integral_constant<int, 4>(), isa.name);
  }
  return team;
}

}  // namespace raysweep
