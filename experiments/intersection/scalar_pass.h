// One ray with one triangle at a time.
#pragma once

#include <vector>

#include "experiments/intersection/kernel.h"
#include "tracer/intersect/solve.h"

namespace raysweep {

/// Triangles are an array of structures.
template <class Method, Variant variant, class T>
class ScalarPass : public KernelPass {
 public:
  explicit ScalarPass(const Workload<T>& work) : work_(work) {
    constants_.reserve(work.triangles.size());
    for (const Triangle<T>& triangle : work.triangles) {
      if constexpr (variant.data == Data::bare) {
        constants_.push_back(triangle);
      } else {
        constants_.push_back(Method::prepare(triangle));
      }
    }
  }

  RAYSWEEP_FLATTEN [[nodiscard]] PassResult run(Answer* answers) override {
    uint64_t hits = 0;
    T sum = 0;
    size_t answered = 0;  // before this ray
    for (const Visit<T>& visit : work_.visits) {
      const auto* const first = constants_.data() + visit.first_triangle;
      for (uint32_t r = 0; r < work_.rays_a_visit; ++r, answered += visit.triangle_count) {
        const Ray<T>& ray = work_.rays[visit.first_ray + r];
        for (uint32_t i = 0; i < visit.triangle_count; ++i) {
          const Solution<T> found = solve_lanes<Method, variant, T>(ray, first[i], visit.t_max);
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
  const Workload<T>& work_;
  std::vector<TriangleFor<Method, variant, T>> constants_;
};

}  // namespace raysweep
