// One ray with one triangle at a time.
#pragma once

#include <vector>

#include "experiments/intersection/kernel.h"
#include "experiments/intersection/layout.h"
#include "tracer/intersect/solve.h"

namespace raysweep {

template <class Method, Variant variant, class T, Layout layout = Layout::aos>
class ScalarPass : public KernelPass {
 public:
  explicit ScalarPass(const Workload<T>& work) : work_(work), constants_(constants_of(work.triangles)) {}

  RAYSWEEP_FLATTEN [[nodiscard]] PassResult run(Answer* answers) override {
    uint64_t hits = 0;
    T sum = 0;
    size_t answered = 0;  // before this ray
    for (const Visit<T>& visit : work_.visits) {
      for (uint32_t r = 0; r < work_.rays_a_visit; ++r, answered += visit.triangle_count) {
        const Ray<T>& ray = work_.rays[visit.first_ray + r];
        for (uint32_t i = 0; i < visit.triangle_count; ++i) {
          const Solution<T> found =
              solve_lanes<Method, variant, T>(ray, constants_[visit.first_triangle + i], visit.t_max);
          if (!found.accepted) continue;
          ++hits;
          if constexpr (variant.output != Output::hit) sum += found.t;
          if constexpr (variant.output == Output::weights) sum += found.beta + found.gamma;
          if (answers) answers[answered + i] = {true, found.t, found.beta, found.gamma};
        }
      }
    }
    return {hits, static_cast<double>(sum)};
  }

 private:
  using Constants = TriangleFor<Method, variant, T>;

  [[nodiscard]] static std::vector<Constants> constants_of(const std::vector<Triangle<T>>& triangles) {
    std::vector<Constants> all;
    all.reserve(triangles.size());
    for (const Triangle<T>& triangle : triangles) all.push_back(data_for<Method, variant>(triangle));
    return all;
  }

  const Workload<T>& work_;
  ConstantList<Constants, T, layout> constants_;
};

}  // namespace raysweep
