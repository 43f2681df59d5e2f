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

std::vector<std::vector<double>> times_of(const Scene& scene, const std::vector<MethodChoice>& choices,
                                          const AdviceRequest& request) {
  std::vector<RenderSettings> settings;
  for (const MethodChoice& choice : choices) {
    settings.push_back(request.settings);
    settings.back().method = choice.method;
    settings.back().precision = choice.precision;
  }
  return time_pictures(scene, settings, request.rounds);
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
  const std::vector<MethodChoice> choices = choices_by_cost(request.settings.core);
  // Before the sampling, which builds a hierarchy and drops it: the first renderer would get its memory.
  const auto times = times_of(scene, choices, request);
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
  for (const Prediction& one : predict(choices, samples[0], advice.size)) {
    const auto [method, precision] = one.choice;
    advice.all.push_back({one, as_share(measured_error(method, precision, samples[1]), advice.size),
                          times[advice.all.size()]});
  }
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
