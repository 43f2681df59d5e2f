// Contestants on the same rays, in rounds, one after the other in a random order.
#pragma once

#include <array>
#include <span>

#include "experiments/peers/contestant.h"
#include "experiments/peers/hits.h"

namespace raysweep {

struct DuelOptions {
  int rounds = 15;
  double run_seconds = 0.02;  // shorter runs are repeated until they have taken about as long
  uint64_t seed = 1;          // of the order in each round
};

/// What pairs may be compared as.
enum class DuelClass { single, best, robust };
inline constexpr std::array duel_class_names{"single", "best", "robust"};

/// Whether an entrant may stand for its team in `duel_class`. `single`: one ray at a time. `best`: whatever
/// is fastest without promises at edges. `robust`: with them.
[[nodiscard]] bool may_enter(const Entrant& entrant, DuelClass duel_class);

/// A contestant far behind the best of its team and class in the qualifying runs has no chance to be the best
/// and takes no time in the rounds.
inline constexpr double qualifying_share = 0.75;
/// The fastest counts, lest other load on the machine disqualifies the best.
inline constexpr int qualifying_runs = 3;

/// How an entrant did, in rays per second.
struct Performance {
  const Entrant* entrant = nullptr;
  bool ours = false;
  double qualifying = 0;
  std::vector<double> rounds;    // empty: did not qualify
  HitDifferences from_oracle{};  // counted in the first run
};

/// What entrants are held against.
struct OracleHits {
  HitBatch usual, robust;

  [[nodiscard]] const HitBatch& of(const Entrant& entrant) const { return entrant.robust ? robust : usual; }
};

/// Both teams on `rays`. Each entrant runs to warm up, when its hits are held against its `oracle`, and to
/// qualify. Then, in each round, all that qualified run, each reset before; only `run` is timed.
[[nodiscard]] std::vector<Performance> duel(const Team& ours, const Team& embree, const RayBatch& rays,
                                            bool any_hit, const OracleHits& oracle,
                                            const DuelOptions& options);

/// The fastest of a team in a class by its median over the rounds; null if none entered.
[[nodiscard]] const Performance* best_of(std::span<const Performance> all, bool ours, DuelClass duel_class);

}  // namespace raysweep
