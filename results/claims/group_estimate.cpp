#include "results/claims/group_estimate.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "results/statistics/resampling.h"

namespace raysweep {

namespace {

std::vector<double> values_of(const ObservationList& list) {
  std::vector<double> values;
  for (const Observation* const one : list) values.push_back(one->value.value);
  return values;
}

/// To the first order, worst case: errors of rounding are no noise that would cancel.
Estimate::Bounds digits_interval(const GroupQuestion& question, double value) {
  double reach = 0;
  std::vector<double> moved = values_of(question.needed);
  for (size_t i = 0; i < moved.size(); ++i) {
    const double own = moved[i], half_unit = question.needed[i]->half_unit;
    double most = 0;
    for (const double sign : {-1.0, 1.0}) {
      moved[i] = own + sign * half_unit;
      most = std::max(most, std::abs(question.statistic(moved) - value));
    }
    moved[i] = own;
    reach += most;
  }
  return {value - reach, value + reach};
}

/// The medians of the rounds drawn; none where one has no sample in any of them.
std::optional<std::vector<double>> medians_of(const ObservationList& list, const std::vector<int>& rounds,
                                              const std::vector<size_t>& drawn) {
  std::vector<double> medians, samples;
  for (const Observation* const one : list) {
    if (one->by_round.empty()) {
      medians.push_back(one->value.value);
      continue;
    }
    samples.clear();
    for (const size_t place : drawn) {
      if (const auto found = one->by_round.find(rounds[place]); found != one->by_round.end())
        samples.push_back(found->second);
    }
    if (samples.empty()) return std::nullopt;
    medians.push_back(median(samples));
  }
  return medians;
}

std::optional<Estimate::Bounds> rounds_interval(const GroupQuestion& question) {
  std::set<int> all;
  size_t fewest = SIZE_MAX;
  for (const Observation* const one : question.needed) {
    if (one->by_round.empty()) continue;
    fewest = std::min(fewest, one->by_round.size());
    for (const auto& [round, value] : one->by_round) all.insert(round);
  }
  if (all.empty()) return std::nullopt;
  const std::vector<int> rounds(all.begin(), all.end());
  return bootstrap_places(rounds.size(), fewest,
                          [&](const std::vector<size_t>& drawn) -> std::optional<double> {
                            const auto medians = medians_of(question.needed, rounds, drawn);
                            return medians ? std::optional(question.statistic(*medians)) : std::nullopt;
                          });
}

}  // namespace

Estimate estimate(const GroupQuestion& question) {
  Estimate made;
  made.value = question.statistic(values_of(question.needed));
  made.count = static_cast<int>(question.needed.size());
  const auto is_exact = [](const Observation* one) { return one->exact; };
  const auto is_printed = [](const Observation* one) { return one->half_unit > 0; };
  if (std::ranges::any_of(question.needed, is_printed)) {
    made.interval = digits_interval(question, made.value);
  } else if (std::ranges::all_of(question.needed, is_exact)) {
    made.interval = Estimate::Bounds{made.value, made.value};
  } else {
    made.interval = rounds_interval(question);
  }
  return made;
}

}  // namespace raysweep
