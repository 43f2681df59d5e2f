#include "experiments/intersection/kernel.h"

#include <fmt/format.h>

#include "experiments/intersection/subjects.h"
#include "tracer/intersect/study.h"

namespace raysweep {

namespace {

#if defined(__clang__)
constexpr std::string_view own_compiler = "clang " __clang_version__;
#else
constexpr std::string_view own_compiler = "gcc " __VERSION__;
#endif

/// One ray with one triangle at a time, triangles as an array of structures.
template <class Method, Variant variant, class T>
class ScalarPass : public KernelPass {
 public:
  explicit ScalarPass(const Work<T>& work) : work_(work) {
    constants_.reserve(work.triangles.size());
    for (const Triangle<T>& triangle : work.triangles) {
      if constexpr (variant.data == Data::bare) {
        constants_.push_back(triangle);
      } else {
        constants_.push_back(Method::prepare(triangle));
      }
    }
  }

  [[nodiscard]] PassResult run() override {
    PassResult result;
    for (const Visit<T>& visit : work_.visits) {
      for (uint32_t r = 0; r < work_.rays_a_visit; ++r)
        run_ray(work_.rays[visit.first_ray + r], visit, result);
    }
    return result;
  }

 private:
  void run_ray(const Ray<T>& ray, const Visit<T>& visit, PassResult& result) const {
    const auto* const first = constants_.data() + visit.first_triangle;
    for (uint32_t i = 0; i < visit.triangle_count; ++i) {
      const Solution<T> found = solve_lanes<Method, variant, T>(ray, first[i], visit.t_max);
      if (!found.accepted) continue;
      ++result.hits;
      if constexpr (variant.output != Output::hit) result.sum += static_cast<double>(found.t);
      if constexpr (variant.output == Output::weights)
        result.sum += static_cast<double>(found.beta) + static_cast<double>(found.gamma);
    }
  }

  const Work<T>& work_;
  std::vector<TriangleFor<Method, variant, T>> constants_;
};

template <class Method, Variant variant, class T>
std::unique_ptr<KernelPass> prepare_scalar(const Work<T>& work) {
  return std::make_unique<ScalarPass<Method, variant, T>>(work);
}

template <class T>
std::vector<Kernel<T>> list_kernels() {
  std::vector<Kernel<T>> kernels;
  for_each_study_method([&]<class Method>(Method) {
    for_each_variant<Method, T>([&]<Variant variant>() {
      kernels.push_back({.method = Method::name,
                         .change = change_of(base_variant<Method>(), variant),
                         .variant = variant,
                         .compiler = own_compiler,
                         .isa = "scalar",
                         .bytes = sizeof(TriangleFor<Method, variant, T>),
                         .prepare = prepare_scalar<Method, variant, T>});
    });
  });
  return kernels;
}

}  // namespace

template <class T>
const std::vector<Kernel<T>>& all_kernels() {
  static const std::vector<Kernel<T>> kernels = list_kernels<T>();
  return kernels;
}
template const std::vector<Kernel<float>>& all_kernels();
template const std::vector<Kernel<double>>& all_kernels();

}  // namespace raysweep
