#include "experiments/advise/error_bounds.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "experiments/advise/rounded.h"
#include "tracer/intersect/study.h"

namespace raysweep {

namespace {

using Wide = Vec3<long double>;
constexpr long double infinity = std::numeric_limits<long double>::infinity();

/// The formula's values, accepted or not.
template <class Method, class V>
struct Values {
  V t, beta, gamma;

  Values(const Ray<V>& ray, const Triangle<V>& triangle) {
    constexpr Variant variant = base_variant<Method>();
    using Terms = TermsOf<Method, V>;
    using Test = std::conditional_t<variant.division == Division::early, EarlyTest<variant, Terms, V>,
                                    LateTest<variant, Terms, V>>;
    const Terms terms(ray, Method::prepare(triangle));
    const Test test(terms, greatest(V()));
    t = test.t();
    if constexpr (Method::gives_weights) {
      beta = test.weight(test.beta());
      gamma = test.weight(test.gamma());
    }
  }
};

/// Errors of t, β and γ of the formula's values.
template <class Method, class T>
struct ValueBounds {
  long double t, beta = not_given(0.0), gamma = not_given(0.0);

  ValueBounds(const Ray<Rounded<T>>& ray, const Triangle<Rounded<T>>& triangle) {
    const Values<Method, Rounded<T>> values(ray, triangle);
    t = values.t.error();
    if constexpr (Method::gives_weights) {
      beta = values.beta.error();
      gamma = values.gamma.error();
    }
  }
};

/// t is a mean of the corners' distances z along an axis, weighted by edge functions w, over the direction d
/// on that axis. What errors of weights do to numerator and denominator mostly cancels, which a formula's own
/// books cannot know. With ŵ = w + δ the mean moves by Σδ(z − z*)/Σŵ, since Σw(z − z*) is 0; on a hit z* is
/// between the corners', so that |z − z*| is at most the distance to the farthest of them. β = w_B/Σw moves
/// by (δ_B(1 − β) − β(δ_A + δ_C))/Σŵ, at most the larger of |δ_B| and |δ_A| + |δ_C| over |Σŵ|. Errors of z
/// move the mean by the largest of them at most, as long as all ŵ are of one sign, which hits have. What is
/// left is how the mean itself is rounded, in the study's order of operations or in that of `intersect`.
template <class T>
struct ValueBounds<WoopWatertight, T> {
  using V = Rounded<T>;
  long double t, beta, gamma;

  ValueBounds(const Ray<V>& ray, const Triangle<V>& triangle) {
    const TermsOf<WoopWatertight, V> terms(ray, WoopWatertight::prepare(triangle));
    const auto axis = dominant_axis(ray.direction);
    const auto along_axis = [&](const Vec3<V>& corner) { return project(corner - ray.origin, axis).w; };
    const std::array<V, 3> w{terms.alpha(), terms.beta(), terms.gamma()};
    const std::array<V, 3> z{along_axis(triangle.a), along_axis(triangle.b), along_axis(triangle.c)};
    const V along = V(1) / project(ray.direction, axis).w;
    const Mean mean(w, z, along);
    const auto moved = [&](long double by) { return by / mean.least_whole; };
    long double of_weights = 0, of_distances = 0;
    for (size_t i = 0; i < 3; ++i) {
      long double farthest = 0;
      for (size_t j = 0; j < 3; ++j) farthest = std::max(farthest, most(z[i] - z[j]));
      of_weights += w[i].error() * farthest;
      of_distances = std::max(of_distances, z[i].error());
    }
    t = mean.t_rounding + std::abs(1 / static_cast<long double>(project(ray.direction, axis).w.value())) *
                              (moved(of_weights) + of_distances);
    const auto weight = [&](size_t i) {
      const long double others = w[(i + 1) % 3].error() + w[(i + 2) % 3].error();
      return moved(std::max(w[i].error(), others)) + mean.weight_rounding[i];
    };
    beta = weight(1);
    // Where β + γ is above 1, γ becomes 1 − β.
    gamma = std::max(weight(2), beta + std::numeric_limits<T>::epsilon());
  }

 private:
  /// The largest that the exact value may be, without its sign.
  static long double most(const V& x) { return std::abs(static_cast<long double>(x.value())) + x.error(); }

  /// The mean of what is taken for exact.
  struct Mean {
    long double t_rounding, least_whole;
    std::array<long double, 3> weight_rounding;

    Mean(const std::array<V, 3>& w, const std::array<V, 3>& z, const V& along) {
      const V a = exactly(w[0]), b = exactly(w[1]), c = exactly(w[2]);
      const V at_a = exactly(z[0]), at_b = exactly(z[1]), at_c = exactly(z[2]);
      const V whole = a + b + c, inverse = V(1) / whole;
      const V studied = (a * at_a + b * at_b + c * at_c) * along * inverse;
      const V rendered = (a * inverse * at_a + b * inverse * at_b + c * inverse * at_c) * along;
      t_rounding = std::max(studied.error(), rendered.error());
      weight_rounding = {(a * inverse).error(), (b * inverse).error(), (c * inverse).error()};
      least_whole = std::max(std::abs(static_cast<long double>(whole.value())) - whole.error(), 0.0L);
    }
    static V exactly(const V& x) { return V(x.value()); }
  };
};

/// What weights that are off by `beta` and `gamma` move the point that they tell.
template <class T>
long double moved_by_weights(const Triangle<T>& triangle, long double beta, long double gamma) {
  const Wide a(triangle.a), ab = Wide(triangle.b) - a, ac = Wide(triangle.c) - a;
  return beta * length(ab) + gamma * length(ac);
}

/// NaN is infinity less infinity, or 0 times it: nothing is known.
long double or_unknown(long double bound) { return std::isnan(bound) ? infinity : bound; }

template <class Method, class T>
HitBound bound_of(const Ray<T>& ray, const Triangle<T>& triangle) {
  using V = Rounded<T>;
  const ValueBounds<Method, T> values({Vec3<V>(ray.origin), Vec3<V>(ray.direction)},
                                      triangle.template as<V>());
  HitBound bound{or_unknown(values.t), values.beta, values.gamma, 0};
  bound.point = or_unknown(bound.t * length(Wide(ray.direction)));
  if constexpr (Method::gives_weights) {
    bound.beta = or_unknown(bound.beta);
    bound.gamma = or_unknown(bound.gamma);
    bound.point = std::max(bound.point, or_unknown(moved_by_weights(triangle, bound.beta, bound.gamma)));
  }
  return bound;
}

template <class T>
std::vector<ErrorLaw<T>> list_laws() {
  std::vector<ErrorLaw<T>> laws;
  for_each_study_method([&]<class Method>(Method) { laws.push_back({Method::name, bound_of<Method, T>}); });
  return laws;
}

}  // namespace

template <class T>
std::span<const ErrorLaw<T>> error_laws() {
  static const std::vector<ErrorLaw<T>> laws = list_laws<T>();
  return laws;
}

template <class T>
const ErrorLaw<T>& error_law_of(std::string_view method) {
  for (const ErrorLaw<T>& law : error_laws<T>()) {
    if (law.method == method) return law;
  }
  throw std::out_of_range("no method of the study is called " + std::string(method));
}

template <class T>
long double point_error(const Ray<T>& ray, const Triangle<T>& triangle, const TriangleHit<T>& hit,
                        long double t, long double beta, long double gamma) {
  const long double along = std::abs(hit.t - t) * length(Wide(ray.direction));
  if (std::isnan(hit.beta)) return along;
  const Wide a(triangle.a), ab = Wide(triangle.b) - a, ac = Wide(triangle.c) - a;
  return std::max(along, length(ab * (hit.beta - beta) + ac * (hit.gamma - gamma)));
}

template std::span<const ErrorLaw<float>> error_laws();
template std::span<const ErrorLaw<double>> error_laws();
template const ErrorLaw<float>& error_law_of(std::string_view);
template const ErrorLaw<double>& error_law_of(std::string_view);
template long double point_error(const Ray<float>&, const Triangle<float>&, const TriangleHit<float>&,
                                 long double, long double, long double);
template long double point_error(const Ray<double>&, const Triangle<double>&, const TriangleHit<double>&,
                                 long double, long double, long double);

}  // namespace raysweep
