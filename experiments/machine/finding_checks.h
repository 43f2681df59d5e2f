// The single checks of `judge`. To add one: here, in the list of findings.cpp, and its good, bad and unknown
// case in the tests, which ask for all three.
#pragma once

#include "experiments/machine/findings.h"

namespace raysweep {

/// What a difference must exceed to be seen: half-width of the intervals that runs aim at by default.
inline constexpr double target_half_width = 0.02;

using Check = Finding (*)(const Examination&);

/// Set-up of processors and memory, which somebody chose.
Finding check_quota(const Examination& e);
Finding check_allowed(const Examination& e);
Finding check_smt(const Examination& e);
Finding check_turbo(const Examination& e);
Finding check_governor(const Examination& e);
Finding check_virtual_machine(const Examination& e);
Finding check_clock(const Examination& e);
Finding check_huge_pages(const Examination& e);
Finding check_layout(const Examination& e);
Finding check_build(const Examination& e);

/// What went on while it was watched, and just before.
Finding check_throttling(const Examination& e);
Finding check_steal(const Examination& e);
Finding check_pressure(const Examination& e);
Finding check_other_load(const Examination& e);
Finding check_load_average(const Examination& e);
Finding check_frequency(const Examination& e);
Finding check_swap(const Examination& e);
Finding check_memory(const Examination& e);
Finding check_noise(const Examination& e);

[[nodiscard]] inline Finding good(std::string name, std::string value) {
  return {std::move(name), FindingState::good, std::move(value), {}, {}};
}
[[nodiscard]] inline Finding unknown(std::string name, std::string why) {
  return {std::move(name), FindingState::unknown, {}, std::move(why), {}};
}
[[nodiscard]] inline Finding bad(std::string name, std::string value, std::string why, std::string advice) {
  return {std::move(name), FindingState::bad, std::move(value), std::move(why), std::move(advice)};
}

}  // namespace raysweep
