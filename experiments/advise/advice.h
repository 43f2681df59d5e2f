// Which method keeps a tolerance on a scene, and which of them is the cheapest.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/advise/hit_sample.h"
#include "experiments/advise/sample_errors.h"
#include "results/statistics/statistics.h"

namespace raysweep {

/// The *hit tolerance* is how far a hit point may be from the true one, as a share of the scene's size, which
/// is the diagonal of the box around all its triangles: 1e-4 of a room of 10 m is 1 mm. Users know how large
/// what they look at is; they know neither its units in the last place nor how long each ray is, and a share
/// of the ray's length would ask the more of a hit the nearer it is. All but one in a thousand of a scene's
/// hits must keep it. True is what real numbers make of the ray and the triangle as they are given.
/// By default a tenth of a pixel where a picture of 1000 pixels shows the whole scene.
inline constexpr double default_hit_tolerance = 1e-4;

/// The sentence about a tolerance that is not possible; empty if there is nothing wrong.
[[nodiscard]] std::string tolerance_problem(double tolerance);

/// What the tracer can render with.
struct MethodChoice {
  std::string_view method, precision;

  friend bool operator==(const MethodChoice&, const MethodChoice&) = default;
};

/// All methods in all precisions that `core` has, the cheapest first. The order is fixed, so that a picture
/// depends on its scene and settings alone, never on what a clock said. Float comes before double since it
/// halves what a scene takes of memory; `advise` shows them within a few percent of each other on built-in
/// scenes, either way. So are `moller_trumbore` and `morozov`, while `woop_watertight` took 1 to 20 percent
/// more. `advise` itself goes by its own times.
[[nodiscard]] std::vector<MethodChoice> choices_by_cost(std::string_view core);

/// A choice with the error that its hit points keep, as a share of the scene's size.
struct Prediction {
  MethodChoice choice;
  double bound = 0;  // infinite where nothing can be promised; 0 where no triangle is hit

  [[nodiscard]] bool keeps(double tolerance) const { return bound <= tolerance; }
};

/// Of each of `choices`, in their order. Lengths in `hits` and `size` have one unit.
[[nodiscard]] std::vector<Prediction> predict(const std::vector<MethodChoice>& choices,
                                              const std::vector<SampledHit>& hits, double size);

/// The first that keeps `tolerance`; none where none does.
[[nodiscard]] std::optional<Prediction> first_that_keeps(const std::vector<Prediction>& all,
                                                         double tolerance);

/// "no method can promise a hit tolerance of 1e-12; the smallest that can be is 3.2e-15, by …"
[[nodiscard]] std::string refusal(const std::vector<Prediction>& all, double tolerance);

/// One line of advice.
struct Advised {
  Prediction predicted;
  Measurement measured;             // its errors as shares of the scene's size
  std::vector<double> nanoseconds;  // a ray, of each round; all lines have the same rounds

  /// Whether it is promised to, or shown by measurement.
  [[nodiscard]] bool keeps(double tolerance) const {
    return predicted.keeps(tolerance) || measured.shown <= tolerance;
  }
};

/// Indices of `all`; none where nothing keeps the tolerance.
struct Ranking {
  std::optional<size_t> choice, runner_up;
};
/// Of those that keep the tolerance the quickest by its median over the rounds, then the next.
[[nodiscard]] Ranking rank(const std::vector<Advised>& all, double tolerance);

/// How much longer `slower` takes than `quicker`: the median of the ratios of each round.
[[nodiscard]] Estimate time_ratio(const Advised& slower, const Advised& quicker);

/// A choice is to be at most so much slower than the quickest that keeps the tolerance.
inline constexpr double enough_certainty = 0.05;

/// By how much the choice may yet be slower than another that keeps `tolerance`, as a share of that one's
/// time: the greatest by the lower ends of the ratios' 95 % intervals, 0 where each shows the choice to be
/// quicker. None without a choice or without intervals.
[[nodiscard]] std::optional<double> most_slower(const std::vector<Advised>& all, const Ranking& ranking,
                                                double tolerance);

/// What is to be done, and why, in a sentence or two.
[[nodiscard]] std::string advice_text(const std::vector<Advised>& all, const Ranking& ranking,
                                      double tolerance);

}  // namespace raysweep
