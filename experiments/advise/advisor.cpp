#include "experiments/advise/advisor.h"

#include <algorithm>

#include "experiments/advise/error_bounds.h"
#include "experiments/errors.h"
#include "tracer/scene/scene.h"

namespace raysweep {

namespace {

Measurement as_share(Measurement measured, double size) {
  if (size > 0) {
    measured.error /= size;
    measured.shown /= size;
  }
  return measured;
}

std::vector<RenderSettings> settings_of(const std::vector<MethodChoice>& choices,
                                        const RenderSettings& common) {
  std::vector<RenderSettings> settings(choices.size(), common);
  for (size_t i = 0; i < choices.size(); ++i) {
    settings[i].method = choices[i].method;
    settings[i].precision = choices[i].precision;
  }
  return settings;
}

/// Whether the quickest by these times is so with enough certainty, or nothing can be chosen.
bool is_certain(std::vector<Advised> all, const RoundTimes& times, double tolerance) {
  for (size_t i = 0; i < all.size(); ++i) all[i].nanoseconds = times[i];
  const Ranking ranking = rank(all, tolerance);
  if (!ranking.choice) return true;
  const std::optional<double> share = most_slower(all, ranking, tolerance);
  return share && *share <= enough_certainty;
}

/// Kernels take a tenth of the pictures' time.
std::vector<StudyLine> study_of(const AdviceRequest& request, double size,
                                const std::vector<SampledHit>& to_predict,
                                const std::vector<SampledHit>& to_measure) {
  RoundOptions rounds = request.rounds;
  rounds.seconds /= 10;
  std::vector<StudyLine> study;
  for (const TimedKernel& kernel : time_kernels(to_measure, rounds)) {
    study.push_back({{kernel.method, kernel.precision},
                     predicted_error(kernel.method, kernel.precision, to_predict) / size,
                     as_share(measured_error(kernel.method, kernel.precision, to_measure), size),
                     kernel.nanoseconds});
  }
  return study;
}

/// Measures all on `hits`, as shares of the scene's size.
void measure(Advice& advice, const std::vector<SampledHit>& hits) {
  advice.measured_hits = hits.size();
  for (Advised& one : advice.all) {
    const auto [method, precision] = one.predicted.choice;
    one.measured = as_share(measured_error(method, precision, hits), advice.size);
  }
}

/// Whether some kept the tolerance that neither promise it nor are shown to.
bool is_open(const Advice& advice) {
  return std::ranges::any_of(advice.all, [&](const Advised& one) {
    return one.measured.error <= advice.tolerance && !one.keeps(advice.tolerance);
  });
}

}  // namespace

Advice advise(const Scene& scene, const AdviceRequest& request) {
  const std::vector<MethodChoice> choices = choices_by_cost(request.settings.core);
  // Before the sampling, which builds a hierarchy and drops it: the first renderer would get its memory.
  PictureRace race(scene, settings_of(choices, request.settings), request.rounds);
  const auto samples = sample_hits(scene, {predicted_sample, measured_sample});
  Advice advice;
  advice.scene = scene.name;
  advice.core = request.settings.core;
  advice.triangles = scene.triangle_count();
  advice.predicted_hits = samples[0].size();
  advice.size = scene_size(scene);
  advice.tolerance = request.tolerance;
  advice.numbers = numbers_of(samples[0]);
  for (const Prediction& one : predict(choices, samples[0], advice.size)) advice.all.push_back({one, {}, {}});
  measure(advice, samples[1]);
  if (is_open(advice)) measure(advice, sample_hits(scene, {decisive_sample})[0]);
  const RoundTimes times =
      race.run([&](const RoundTimes& so_far) { return is_certain(advice.all, so_far, request.tolerance); });
  for (size_t i = 0; i < times.size(); ++i) advice.all[i].nanoseconds = times[i];
  advice.ranking = rank(advice.all, request.tolerance);
  advice.study = study_of(request, advice.size, samples[0], samples[1]);
  return advice;
}

Prediction choose_method(const Scene& scene, std::string_view core, std::string_view precision,
                         double tolerance) {
  std::vector<MethodChoice> choices = choices_by_cost(core);
  if (!precision.empty())
    std::erase_if(choices, [&](const MethodChoice& choice) { return choice.precision != precision; });
  const auto samples = sample_hits(scene, {predicted_sample});
  const std::vector<Prediction> all = predict(choices, samples[0], scene_size(scene));
  if (const auto first = first_that_keeps(all, tolerance)) return *first;
  throw RequestError(refusal(all, tolerance));
}

}  // namespace raysweep
