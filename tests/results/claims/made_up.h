// Observations for tests of claims.
#pragma once

#include <vector>

#include "results/claims/judge.h"

namespace raysweep {

/// Measured in `rounds` rounds, whose values lie within ±1 % of `value`, each cell in an order of its own.
inline Observation measured(Factors factors, double value, int rounds = 7) {
  int shift = 0;
  for (const auto& [name, text] : factors) shift += text.back();
  std::map<int, double> by_round;
  for (int round = 0; round < rounds; ++round)
    by_round[round] = value * (1 + 0.01 * ((round + shift) % rounds - rounds / 2) / (rounds / 2));
  Observation made = observation_of(std::move(by_round));
  made.factors = std::move(factors);
  return made;
}

/// Printed with three decimals.
inline Observation printed(Factors factors, double value) {
  Observation made;
  made.factors = std::move(factors);
  made.value.value = value;
  made.value.count = 1;
  made.half_unit = 0.0005;
  return made;
}

using Make = Observation (*)(Factors, double);

inline Observation measured_usually(Factors factors, double value) {
  return measured(std::move(factors), value);
}

/// fps by threads, of one mode.
inline std::vector<Observation> by_threads(Make make, const std::vector<std::pair<int, double>>& values,
                                           const std::string& mode = "low") {
  std::vector<Observation> list;
  for (const auto& [threads, value] : values)
    list.push_back(make({{"threads", std::to_string(threads)}, {"mode", mode}}, value));
  return list;
}

}  // namespace raysweep
