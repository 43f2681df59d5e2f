// Simulated launches for tests of statistics: what goes in is known, so what comes out can be counted.
#pragma once

#include <cmath>
#include <random>
#include <string>
#include <vector>

namespace raysweep {

/// Draws log fps of equal launches.
class Simulated {
 public:
  explicit Simulated(std::string kind) : kind_(std::move(kind)), random_(7) {}

  double operator()() {
    if (kind_ == "normal") return 0.02 * normal_(random_);
    if (kind_ == "log-normal") return -0.02 * std::exp(normal_(random_));  // always slow launches, never fast
    if (kind_ == "bimodal") return 0.005 * normal_(random_) - (uniform_(random_) < 0.1 ? std::log(1.2) : 0);
    return 0.01 * heavy_(random_);
  }

  std::vector<double> list(int count) {
    std::vector<double> values(static_cast<size_t>(count));
    for (double& v : values) v = (*this)();
    return values;
  }

  /// Differences of two equal cells, launch by launch.
  std::vector<double> pairs(int count) {
    std::vector<double> values(static_cast<size_t>(count));
    for (double& v : values) v = (*this)() - (*this)();
    return values;
  }

 private:
  std::string kind_;
  std::mt19937_64 random_;
  std::normal_distribution<double> normal_;
  std::uniform_real_distribution<double> uniform_;
  std::student_t_distribution<double> heavy_{2};  // its variance is infinite
};

inline const std::vector<std::string> simulated_kinds{"normal", "log-normal", "bimodal", "heavy-tailed"};

}  // namespace raysweep
