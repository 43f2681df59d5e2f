#include "experiments/overhead/comparison.h"

namespace raysweep {

Comparison compare(const std::vector<Round>& rounds) {
  std::vector<double> direct, ours, difference, ratio;
  for (const Round& round : rounds) {
    direct.push_back(round.direct);
    ours.push_back(round.ours);
    difference.push_back(round.ours - round.direct);
    ratio.push_back(round.ours / round.direct);
  }
  return {estimate_median(direct), estimate_median(ours), estimate_median(difference),
          estimate_median(ratio)};
}

OverheadVerdict judge(const Comparison& comparison) {
  const auto& difference = comparison.difference.interval;
  const auto& ratio = comparison.ratio.interval;
  if (!difference || !ratio) return OverheadVerdict::undecided;
  if (difference->high <= claimed_nanoseconds || ratio->high <= claimed_ratio) return OverheadVerdict::holds;
  if (difference->low > claimed_nanoseconds && ratio->low > claimed_ratio)
    return OverheadVerdict::does_not_hold;
  return OverheadVerdict::undecided;
}

std::string_view text(OverheadVerdict verdict) {
  constexpr std::string_view texts[] = {"holds", "does not hold", "undecided"};
  return texts[static_cast<size_t>(verdict)];
}

std::vector<Round> take_turns(const std::function<double()>& direct, const std::function<double()>& ours,
                              int rounds) {
  std::vector<Round> taken;
  for (int i = -1; i < rounds; ++i) {
    Round round{};
    const bool direct_first = i % 2 == 0;
    if (direct_first) round.direct = direct();
    round.ours = ours();
    if (!direct_first) round.direct = direct();
    if (i >= 0) taken.push_back(round);
  }
  return taken;
}

}  // namespace raysweep
