#include "experiments/advise/sample_errors.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>

#include "experiments/advise/error_bounds.h"
#include "experiments/intersection/oracle.h"
#include "results/statistics/statistics.h"
#include "tracer/intersect/all.h"
#include "tracer/intersect/study.h"

namespace raysweep {

namespace {

template <class T>
using Test = std::optional<TriangleHit<T>> (*)(const Ray<T>& ray, const Triangle<T>& triangle);

template <class Method, class T>
std::optional<TriangleHit<T>> as_rendered(const Ray<T>& ray, const Triangle<T>& triangle) {
  return Method::intersect(ray, Method::prepare(triangle));
}

template <class Method, class T>
std::optional<TriangleHit<T>> as_studied(const Ray<T>& ray, const Triangle<T>& triangle) {
  constexpr Variant variant = base_variant<Method>();
  return solve<Method, variant, T>(ray, Method::prepare(triangle), std::numeric_limits<T>::infinity());
}

template <class T>
Test<T> test_of(std::string_view name) {
  Test<T> test = nullptr;
  for_each_study_method([&]<class Method>(Method) {
    if (name != Method::name) return;
    if constexpr (Intersector<Method, T>) {
      test = as_rendered<Method, T>;
    } else {
      test = as_studied<Method, T>;
    }
  });
  if (!test) throw std::out_of_range("no method of the study is called " + std::string(name));
  return test;
}

template <class T>
Ray<T> ray_of(const SampledHit& hit) {
  return {Vec3<T>(hit.ray.origin), Vec3<T>(hit.ray.direction)};
}

template <class T>
double predicted(std::string_view method, const std::vector<SampledHit>& hits) {
  const ErrorLaw<T>& law = error_law_of<T>(method);
  std::vector<double> bounds;
  bounds.reserve(hits.size());
  for (const SampledHit& hit : hits)
    bounds.push_back(static_cast<double>(law.bound(ray_of<T>(hit), hit.triangle.as<T>()).point));
  return kept_error(std::move(bounds));
}

template <class T>
Measurement measured(std::string_view method, const std::vector<SampledHit>& hits) {
  const Test<T> test = test_of<T>(method);
  Measurement measurement;
  std::vector<double> errors;
  for (const SampledHit& sampled : hits) {
    const Ray<T> ray = ray_of<T>(sampled);
    const Triangle<T> triangle = sampled.triangle.as<T>();
    const ExactHit exact = exact_hit(ray, triangle);
    if (exact.verdict == ExactVerdict::miss || std::isnan(exact.t)) continue;
    if (const auto hit = test(ray, triangle)) {
      errors.push_back(
          static_cast<double>(point_error(ray, triangle, *hit, exact.t, exact.beta, exact.gamma)));
    } else {
      measurement.missed += exact.verdict == ExactVerdict::hit;
    }
  }
  measurement.error = kept_error(errors);
  errors.resize(errors.size() + measurement.missed, std::numeric_limits<double>::infinity());
  measurement.shown = shown_error(std::move(errors));
  return measurement;
}

bool is_double(std::string_view precision) {
  if (precision != "float" && precision != "double")
    throw std::out_of_range("precision is float or double, not " + std::string(precision));
  return precision == "double";
}

}  // namespace

double kept_error(std::vector<double> errors) {
  if (errors.empty()) return 0;
  const auto index = std::ceil(kept_share * static_cast<double>(errors.size())) - 1;
  const auto kept = errors.begin() + static_cast<std::ptrdiff_t>(index);
  std::nth_element(errors.begin(), kept, errors.end());
  return *kept;
}

double shown_error(std::vector<double> errors) {
  if (errors.empty()) return 0;
  const std::optional<int> rank = upper_bound_rank(static_cast<int>(errors.size()), kept_share);
  if (!rank) return std::numeric_limits<double>::infinity();
  const auto at = errors.end() - 1 - *rank;
  std::nth_element(errors.begin(), at, errors.end());
  return *at;
}

double predicted_error(std::string_view method, std::string_view precision,
                       const std::vector<SampledHit>& hits) {
  return is_double(precision) ? predicted<double>(method, hits) : predicted<float>(method, hits);
}

Measurement measured_error(std::string_view method, std::string_view precision,
                           const std::vector<SampledHit>& hits) {
  return is_double(precision) ? measured<double>(method, hits) : measured<float>(method, hits);
}

}  // namespace raysweep
