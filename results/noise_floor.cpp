#include "results/noise_floor.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "results/statistics/random.h"
#include "results/statistics/trimmed_mean.h"

namespace raysweep {

namespace {

constexpr int fewest_pairs = 6;

}  // namespace

double NoiseFloor::least_effect() const {
  constexpr double of_the_clock = 1e-8;
  return std::max(log_ratio.value_or(0), of_the_clock);
}

std::string NoiseFloor::to_text() const {
  if (log_ratio)
    return fmt::format("noise floor: {:.2g} % (A/A of {} pairs)", std::expm1(*log_ratio) * 100, pairs);
  if (pairs == 0) return "noise floor unknown: no A/A pairs";
  return fmt::format("noise floor unknown: {} A/A pair{}, fewer than 6", pairs, pairs == 1 ? "" : "s");
}

NoiseFloor noise_floor(const std::vector<double>& log_ratios, int launches, uint64_t seed) {
  constexpr int draws = 10000;  // the 95 % quantile of so many is good to 0.2 % of probability
  NoiseFloor floor{std::nullopt, static_cast<int>(log_ratios.size())};
  if (floor.pairs < fewest_pairs || launches < 1) return floor;
  Random random(seed);
  std::vector<double> effects, drawn(static_cast<size_t>(launches));
  for (int i = 0; i < draws; ++i) {
    for (double& d : drawn) d = random.sign() * log_ratios[random.index(log_ratios.size())];
    effects.push_back(std::abs(trimmed_mean(drawn).mean));
  }
  // Few pairs know the noise only roughly, as Student's distribution has it.
  const boost::math::students_t student(floor.pairs - 1.0);
  const double wider = quantile(student, 0.975) / quantile(boost::math::normal(), 0.975);
  floor.log_ratio = wider * quantile(std::move(effects), 0.95);
  return floor;
}

std::vector<double> twin_log_ratios(const std::vector<Record>& records) {
  const Launches all(records);
  std::set<std::string> seen;
  std::vector<double> ratios;
  for (const Record& r : records) {
    if (r.twin > 0 || !seen.insert(own_key(r)).second) continue;
    const Rounds& first = all.valid(own_key(r));
    for (const auto& [round, twin] : all.valid(twin_key(r))) {
      const auto other = first.find(round);
      if (other != first.end()) ratios.push_back(std::log(twin->fps() / other->second->fps()));
    }
  }
  return ratios;
}

NoiseFloor noise_floor(const std::vector<Record>& records) {
  std::map<std::string, int> launches;
  for (const Record& r : records) launches[r.cell] += r.valid;
  int fewest = std::numeric_limits<int>::max();
  for (const auto& [cell, count] : launches) {
    if (count >= fewest_pairs) fewest = std::min(fewest, count);
  }
  const bool any = fewest < std::numeric_limits<int>::max();
  return noise_floor(twin_log_ratios(records), any ? fewest : 0);
}

}  // namespace raysweep
