#include "experiments/peers/duel.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "experiments/clock.h"
#include "results/statistics/random.h"
#include "results/statistics/statistics.h"

namespace raysweep {

namespace {

/// Seconds of one run.
double timed_run(Contestant& contestant) {
  contestant.reset();
  const double begin = now_seconds();
  contestant.run();
  return now_seconds() - begin;
}

class Duel {
 public:
  Duel(const RayBatch& rays, const DuelOptions& options)
      : rays_(static_cast<double>(rays.size)), options_(options) {}

  void add(const Team& team, bool ours) {
    for (const Entrant& entrant : team.entrants) all_.push_back({&entrant, ours, 0, {}, {}});
  }

  void qualify(const RayBatch& rays, bool any_hit, const OracleHits& oracle) {
    for (Performance& p : all_) {
      Contestant& contestant = *p.entrant->contestant;
      contestant.prepare(rays, any_hit);
      contestant.reset();
      contestant.run();
      p.from_oracle = differences(contestant.hits(), oracle.of(*p.entrant), rays.size, any_hit);
      double least = timed_run(contestant);
      for (int i = 0; i < qualifying_runs; ++i) least = std::min(least, mean_seconds(contestant, least));
      p.qualifying = rays_ / least;
    }
    for (const Performance& p : all_)
      if (qualifies(p)) finalists_.push_back(static_cast<size_t>(&p - all_.data()));
  }

  void run_rounds() {
    Random random(options_.seed);
    for (int round = 0; round < options_.rounds; ++round) {
      std::vector<size_t> order = finalists_;
      for (size_t left = order.size(); left > 1; --left)
        std::swap(order[left - 1], order[random.index(left)]);
      for (const size_t i : order) {
        Contestant& contestant = *all_[i].entrant->contestant;
        all_[i].rounds.push_back(rays_ / mean_seconds(contestant, rays_ / all_[i].qualifying));
      }
    }
  }

  [[nodiscard]] std::vector<Performance> result() { return std::move(all_); }

 private:
  /// Of as many runs as fill a sample's time, when one takes `expected` seconds.
  [[nodiscard]] double mean_seconds(Contestant& contestant, double expected) const {
    constexpr double most_repeats = 1e5;  // where the clock saw nothing pass
    const double wanted = std::ceil(options_.run_seconds / std::max(expected, 1e-9));
    const int repeats = static_cast<int>(std::clamp(wanted, 1.0, most_repeats));
    double seconds = 0;
    for (int i = 0; i < repeats; ++i) seconds += timed_run(contestant);
    return std::max(seconds / repeats, 1e-9);
  }

  /// In any class that it may enter.
  [[nodiscard]] bool qualifies(const Performance& p) const {
    for (const DuelClass c : {DuelClass::single, DuelClass::best, DuelClass::robust}) {
      if (!may_enter(*p.entrant, c)) continue;
      double best = 0;
      for (const Performance& other : all_)
        if (other.ours == p.ours && may_enter(*other.entrant, c)) best = std::max(best, other.qualifying);
      if (p.qualifying >= qualifying_share * best) return true;
    }
    return false;
  }

  double rays_;
  DuelOptions options_;
  std::vector<Performance> all_;
  std::vector<size_t> finalists_;
};

}  // namespace

bool may_enter(const Entrant& entrant, DuelClass duel_class) {
  switch (duel_class) {
    case DuelClass::single:
      return entrant.single && !entrant.robust;
    case DuelClass::best:
      return !entrant.robust;
    case DuelClass::robust:
      return entrant.robust;
  }
  return false;
}

std::vector<Performance> duel(const Team& ours, const Team& embree, const RayBatch& rays, bool any_hit,
                              const OracleHits& oracle, const DuelOptions& options) {
  Duel duel(rays, options);
  duel.add(ours, true);
  duel.add(embree, false);
  duel.qualify(rays, any_hit, oracle);
  duel.run_rounds();
  return duel.result();
}

const Performance* best_of(std::span<const Performance> all, bool ours, DuelClass duel_class) {
  const Performance* best = nullptr;
  for (const Performance& p : all) {
    if (p.ours != ours || p.rounds.empty() || !may_enter(*p.entrant, duel_class)) continue;
    if (!best || median(p.rounds) > median(best->rounds)) best = &p;
  }
  return best;
}

}  // namespace raysweep
