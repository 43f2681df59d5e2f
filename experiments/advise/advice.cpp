#include "experiments/advise/advice.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace raysweep {

namespace {

std::string name_of(const MethodChoice& choice) {
  return fmt::format("{} in {}", choice.method, choice.precision);
}

std::vector<Prediction> predictions_of(const std::vector<Advised>& all) {
  std::vector<Prediction> predictions;
  for (const Advised& one : all) predictions.push_back(one.predicted);
  return predictions;
}

}  // namespace

std::string tolerance_problem(double tolerance) {
  // Written so that what is no number is refused, too.
  if (tolerance > 0 && tolerance <= 1) return {};
  return fmt::format(
      "hit-tolerance = {} is not possible: a number above 0 and up to 1, the share of the scene's size by "
      "which hit points may be off",
      tolerance);
}

std::vector<MethodChoice> choices_by_cost(std::string_view core) {
  std::vector<MethodChoice> choices;
  for (const std::string_view precision : {"float", "double"}) {
    if (core == "wide" && precision != "float") continue;
    for (const std::string_view method : {"moller_trumbore", "morozov", "woop_watertight"})
      choices.push_back({method, precision});
  }
  return choices;
}

std::vector<Prediction> predict(const std::vector<MethodChoice>& choices, const std::vector<SampledHit>& hits,
                                double size) {
  std::vector<Prediction> all;
  for (const MethodChoice& choice : choices) {
    const double bound = hits.empty() ? 0 : predicted_error(choice.method, choice.precision, hits) / size;
    all.push_back({choice, bound});
  }
  return all;
}

std::optional<Prediction> first_that_keeps(const std::vector<Prediction>& all, double tolerance) {
  for (const Prediction& one : all)
    if (one.keeps(tolerance)) return one;
  return std::nullopt;
}

std::string refusal(const std::vector<Prediction>& all, double tolerance) {
  const auto best = std::min_element(
      all.begin(), all.end(), [](const Prediction& a, const Prediction& b) { return a.bound < b.bound; });
  if (best == all.end() || std::isinf(best->bound)) {
    return fmt::format(
        "no method can promise a hit tolerance of {}, nor any other: more than one hit in a thousand is on a "
        "triangle too thin, or by a ray too flat, for its numbers",
        tolerance);
  }
  // Rounded up: the number must keep what it says.
  const double digit = std::pow(10.0, std::floor(std::log10(best->bound)) - 1);
  return fmt::format("no method can promise a hit tolerance of {}; the smallest that can be is {:.1e}, by {}",
                     tolerance, std::ceil(best->bound / digit) * digit, name_of(best->choice));
}

Ranking rank(const std::vector<Advised>& all, double tolerance) {
  std::vector<size_t> keeping;
  for (size_t i = 0; i < all.size(); ++i)
    if (all[i].keeps(tolerance)) keeping.push_back(i);
  std::stable_sort(keeping.begin(), keeping.end(), [&](size_t a, size_t b) {
    return median(all[a].nanoseconds) < median(all[b].nanoseconds);
  });
  Ranking ranking;
  if (!keeping.empty()) ranking.choice = keeping[0];
  if (keeping.size() > 1) ranking.runner_up = keeping[1];
  return ranking;
}

Estimate time_ratio(const Advised& slower, const Advised& quicker) {
  std::vector<double> ratios;
  for (size_t round = 0; round < slower.nanoseconds.size(); ++round)
    ratios.push_back(slower.nanoseconds[round] / quicker.nanoseconds[round]);
  return estimate_median(std::move(ratios));
}

std::optional<double> most_slower(const std::vector<Advised>& all, const Ranking& ranking, double tolerance) {
  if (!ranking.choice) return std::nullopt;
  double most = 0;
  for (size_t i = 0; i < all.size(); ++i) {
    if (i == *ranking.choice || !all[i].keeps(tolerance)) continue;
    const Estimate ratio = time_ratio(all[i], all[*ranking.choice]);
    if (!ratio.interval) return std::nullopt;
    most = std::max(most, 1 / ratio.interval->low - 1);
  }
  return most;
}

std::string advice_text(const std::vector<Advised>& all, const Ranking& ranking, double tolerance) {
  if (!ranking.choice) return refusal(predictions_of(all), tolerance) + ", and none is measured to keep it.";
  const Advised& choice = all[*ranking.choice];
  std::string text = fmt::format("Take {}: ", name_of(choice.predicted.choice));
  const char* const shown =
      choice.predicted.keeps(tolerance) ? "" : " That it keeps it is measured, at 95 %, not promised.";
  if (!ranking.runner_up)
    return text + fmt::format("nothing else keeps a hit tolerance of {}.{}", tolerance, shown);
  const Advised& next = all[*ranking.runner_up];
  const Estimate ratio = time_ratio(next, choice);
  const auto more = [](double r) { return 100 * (r - 1); };
  text += fmt::format("of what keeps a hit tolerance of {} it takes least time.{} Next is {}, ", tolerance,
                      shown, name_of(next.predicted.choice));
  if (!ratio.interval) return text + fmt::format("{:+.1f} %.", more(ratio.value));
  text += fmt::format("{:+.1f} % [{:.1f}, {:.1f}]", more(ratio.value), more(ratio.interval->low),
                      more(ratio.interval->high));
  if (ratio.interval->low > 1) return text + ".";
  return text + fmt::format(": no difference shown; at most {:.1f} % slower than any of them.",
                            100 * *most_slower(all, ranking, tolerance));
}

}  // namespace raysweep
