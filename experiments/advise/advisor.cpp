#include "experiments/advise/advisor.h"

#include <algorithm>

#include "experiments/advise/error_bounds.h"
#include "experiments/errors.h"
#include "tracer/scene/scene.h"

namespace raysweep {

namespace {

Measurement as_share(Measurement measured, double size) {
  if (size > 0) measured.error /= size;
  return measured;
}

std::vector<Advised> candidates_of(const Scene& scene, const AdviceRequest& request, double size,
                                   const std::vector<SampledHit>& to_predict,
                                   const std::vector<SampledHit>& to_measure) {
  std::vector<Advised> all;
  std::vector<RenderSettings> settings;
  for (const Prediction& one : predict(choices_by_cost(request.settings.core), to_predict, size)) {
    const auto [method, precision] = one.choice;
    all.push_back({one, as_share(measured_error(method, precision, to_measure), size), {}});
    settings.push_back(request.settings);
    settings.back().method = method;
    settings.back().precision = precision;
  }
  const auto times = time_pictures(scene, settings, request.rounds);
  for (size_t i = 0; i < all.size(); ++i) all[i].nanoseconds = times[i];
  return all;
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

}  // namespace

Advice advise(const Scene& scene, const AdviceRequest& request) {
  const auto samples = sample_hits(scene, {predicted_sample, measured_sample});
  Advice advice;
  advice.scene = scene.name;
  advice.core = request.settings.core;
  advice.triangles = scene.triangle_count();
  advice.predicted_hits = samples[0].size();
  advice.measured_hits = samples[1].size();
  advice.size = scene_size(scene);
  advice.tolerance = request.tolerance;
  advice.numbers = numbers_of(samples[0]);
  advice.all = candidates_of(scene, request, advice.size, samples[0], samples[1]);
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
