#include "experiments/intersection/run_subjects.h"

#include "experiments/intersection/kernel_modules.h"

namespace raysweep {

namespace {

constexpr std::string_view contracted = "contraction=on", by_other = "compiler=other";

/// Each ray visits copies of its candidates, so that they stand in a row.
template <class T>
Workload<T> workload_of(const Trials<T>& trials) {
  Workload<T> workload;
  for (const Trial<T>& trial : trials.rays) {
    workload.visits.push_back({static_cast<uint32_t>(workload.rays.size()),
                               static_cast<uint32_t>(workload.triangles.size()), trial.count, trial.t_max});
    workload.rays.push_back(trial.ray);
    for (size_t i = trial.first; i < trial.first + trial.count; ++i)
      workload.triangles.push_back(trials.triangles[trials.candidates[i]]);
  }
  return workload;
}

template <class T>
std::vector<Subject<T>> list_subjects() {
  std::vector<Subject<T>> subjects = all_subjects<T>();
  for (const Kernel<T>& kernel : all_kernels<T>()) {
    const bool is_combination = kernel.combines && kernel.rays == 1 && kernel.triangles == 1;
    if (kernel.change != contracted && kernel.change != by_other && !is_combination) continue;
    subjects.push_back({kernel.method, kernel.change, kernel.variant,
                        [&kernel](const Trials<T>& trials) { return hits_by(kernel, trials); },
                        is_combination});
  }
  return subjects;
}

}  // namespace

template <class T>
Hits<T> hits_by(const Kernel<T>& kernel, const Trials<T>& trials) {
  const Workload<T> workload = workload_of(trials);
  const std::vector<Answer> answers = kernel.prepare(workload)->answers(workload);
  Hits<T> hits(trials.candidates.size());
  size_t answered = 0;
  for (const Trial<T>& trial : trials.rays) {
    for (size_t i = trial.first; i < trial.first + trial.count; ++i) {
      const Answer& answer = answers[answered++];
      if (answer.hit)
        hits[i] = TriangleHit<T>{static_cast<T>(answer.t), static_cast<T>(answer.beta),
                                 static_cast<T>(answer.gamma)};
    }
  }
  return hits;
}
template Hits<float> hits_by(const Kernel<float>&, const Trials<float>&);
template Hits<double> hits_by(const Kernel<double>&, const Trials<double>&);

template <class T>
const std::vector<Subject<T>>& run_subjects() {
  static const std::vector<Subject<T>> subjects = list_subjects<T>();
  return subjects;
}
template const std::vector<Subject<float>>& run_subjects();
template const std::vector<Subject<double>>& run_subjects();

const std::vector<Inapplicable>& inapplicable_here() {
  static const std::vector<Inapplicable> all = [] {
    std::vector<Inapplicable> list = inapplicable_subjects();
    const auto add = [&](std::string_view module, std::string_view change) {
      const std::string why = why_no_kernels(module);
      if (why.empty()) return;
      for (const std::string_view method : study_method_names()) {
        for (const std::string_view precision : {"float", "double"})
          list.push_back({method, std::string(change), precision, "the module of these kernels " + why});
      }
    };
    add("contracted", contracted);
    add("other_compiler", by_other);
    return list;
  }();
  return all;
}

}  // namespace raysweep
