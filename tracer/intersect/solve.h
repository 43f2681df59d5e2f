// Computes a method's formula in a variant and decides.
#pragma once

#include <optional>
#include <type_traits>

#include "tracer/intersect/variant.h"

namespace raysweep {

/// What comparisons of `V` give.
template <class V>
using MaskOf = decltype(V() < V());

/// Where `accepted`, the other numbers hold, as far as the variant's output has them.
template <class V>
struct Solution {
  MaskOf<V> accepted;
  V t, beta, gamma;
};

template <Reciprocal reciprocal, class V>
[[nodiscard]] V inverse_of(const V& x) {
  if constexpr (reciprocal == Reciprocal::exact) {
    return V(1) / x;
  } else {
    const V y = approximate_reciprocal(x);  // of 0 it is infinite, and what is below NaN
    return y + y - x * (y * y);
  }
}

/// Which members the terms of a method have.
template <class Terms, class V>
struct Shape {
  static constexpr bool is_plane_first = requires(const Terms& terms, const V& v) { terms.at(v, v); };
  static constexpr bool has_sides = is_plane_first || requires(const Terms& terms) { terms.beta(); };
  static constexpr bool has_whole = requires(const Terms& terms) { terms.whole(); };
  static constexpr bool has_alpha = requires(const Terms& terms) { terms.alpha(); }
  || requires(const Terms& terms, const V& v) { terms.at(v, v).alpha(); };
};

/// What is compared if division comes first: t, and weights of which the whole is 1.
template <Variant variant, class Terms, class V>
class EarlyTest : public Shape<Terms, V> {
 public:
  /// `t_max` may be infinite.
  EarlyTest(const Terms& terms, const V& t_max)
      : terms_(terms), inverse_(inverse_of<variant.reciprocal>(terms.det())), t_max_(t_max) {}

  [[nodiscard]] auto is_between() const { return both(t() > V(0), t() < t_max_); }
  [[nodiscard]] auto encloses() const { return terms_.encloses(t()); }
  [[nodiscard]] V alpha() const { return sides().alpha(); }
  [[nodiscard]] V beta() const { return scaled(sides().beta()); }
  [[nodiscard]] V gamma() const { return scaled(sides().gamma()); }
  [[nodiscard]] V whole() const { return V(1); }
  [[nodiscard]] V t() const { return terms_.t() * inverse_; }
  [[nodiscard]] V weight(const V& compared) const { return compared; }

 private:
  [[nodiscard]] auto sides() const {
    if constexpr (EarlyTest::is_plane_first) {
      return terms_.at(t(), V(1));
    } else {
      return Inverted{terms_, inverse_};
    }
  }
  struct Inverted {
    const Terms& terms;
    V inverse;
    [[nodiscard]] V alpha() const { return terms.alpha() * inverse; }
    [[nodiscard]] V beta() const { return terms.beta() * inverse; }
    [[nodiscard]] V gamma() const { return terms.gamma() * inverse; }
  };
  [[nodiscard]] V scaled(const V& side) const {
    if constexpr (EarlyTest::has_whole) {
      return side * inverse_of<variant.reciprocal>(terms_.whole());
    } else {
      return side;
    }
  }

  const Terms& terms_;
  V inverse_, t_max_;
};

/// What is compared if division comes last: numerators, with the sign that makes their denominator positive.
template <Variant variant, class Terms, class V>
class LateTest : public Shape<Terms, V> {
 public:
  /// `t_max` may be infinite. A limit that is finite makes det = 0 a miss, and t that would be infinite.
  LateTest(const Terms& terms, const V& t_max)
      : terms_(terms), det_(terms.det()), limit_(select(t_max > greatest(V()), greatest(V()), t_max)) {}

  [[nodiscard]] auto is_between() const {
    const V t = positive(terms_.t(), det_), det = positive(det_, det_);
    // A direction with an infinity makes det infinite, and everything is less than that.
    return both(both(t > V(0), t < limit_ * det), det <= greatest(V()));
  }
  [[nodiscard]] V alpha() const { return positive(sides().alpha(), scale()); }
  [[nodiscard]] V beta() const { return positive(sides().beta(), scale()); }
  [[nodiscard]] V gamma() const { return positive(sides().gamma(), scale()); }
  [[nodiscard]] V whole() const { return positive(scale(), scale()); }
  [[nodiscard]] V t() const { return terms_.t() * inverse_of<variant.reciprocal>(det_); }
  [[nodiscard]] V weight(const V& compared) const {
    return compared * inverse_of<variant.reciprocal>(whole());
  }

 private:
  [[nodiscard]] static V positive(const V& x, const V& sign) { return select(sign < V(0), V(-x), x); }
  [[nodiscard]] decltype(auto) sides() const {
    if constexpr (LateTest::is_plane_first) {
      return terms_.at(terms_.t(), det_);
    } else {
      return (terms_);
    }
  }
  [[nodiscard]] V scale() const {
    if constexpr (LateTest::has_whole) {
      return det_ * terms_.whole();
    } else {
      return det_;
    }
  }

  const Terms& terms_;
  V det_, limit_;
};

template <Edges edges, class V>
[[nodiscard]] auto is_inside(const V& weight) {
  if constexpr (edges == Edges::strict) {
    return weight > V(0);
  } else {
    return weight >= V(0);
  }
}

/// Whether α, or 1 − β − γ, says that the point is inside.
template <Edges edges, class Test, class V>
[[nodiscard]] auto is_inside_of_bc(const Test& test, const V& beta, const V& gamma) {
  if constexpr (Test::has_alpha) {
    return is_inside<edges>(test.alpha());
  } else if constexpr (edges == Edges::strict) {
    return beta + gamma < test.whole();
  } else {
    return beta + gamma <= test.whole();
  }
}

/// Compares in the order of the variant. Every comparison says what holds of a hit: NaN fails it.
/// Always inlined, as are those below: left to the compiler, calls cost some methods more than their formula.
template <Variant variant, class V, class Test>
[[nodiscard, gnu::always_inline]] inline Solution<V> decide(const Test& test) {
  const V unknown = not_given(V());
  Solution<V> solution{V(0) <= V(0), unknown, unknown, unknown};
  const auto ends_at = [&](const MaskOf<V>& claim) {
    solution.accepted = both(solution.accepted, claim);
    return variant.early_out == EarlyOut::yes && none(solution.accepted);
  };
  if (variant.order == Order::distance_first && ends_at(test.is_between())) return solution;
  if constexpr (Test::has_sides) {
    const V beta = test.beta();
    if (ends_at(is_inside<variant.edges>(beta))) return solution;
    const V gamma = test.gamma();
    if (ends_at(is_inside<variant.edges>(gamma))) return solution;
    if (ends_at(is_inside_of_bc<variant.edges>(test, beta, gamma))) return solution;
    if (variant.order == Order::weights_first && ends_at(test.is_between())) return solution;
    if constexpr (variant.output == Output::weights) {
      solution.beta = test.weight(beta);
      solution.gamma = test.weight(gamma);
    }
  } else {
    if (ends_at(test.encloses())) return solution;
  }
  if constexpr (variant.early_out == EarlyOut::folded) {
    const V b = select(solution.accepted, V(1), V(0));
    solution.t = b * test.t() + b - V(1);
    solution.accepted = negation(solution.t < V(0));
  } else if constexpr (variant.output != Output::hit) {
    solution.t = test.t();
  }
  return solution;
}

/// What a test reads of a triangle.
template <class Method, Variant variant, class V>
using TriangleFor =
    std::conditional_t<variant.data == Data::bare, Triangle<V>, typename Method::template Prepared<V>>;
template <class Method, Variant variant, class V>
[[nodiscard]] TriangleFor<Method, variant, V> data_for(const Triangle<V>& triangle) {
  if constexpr (variant.data == Data::bare) {
    return triangle;
  } else if constexpr (variant.data == Data::from_double) {
    return prepare_in<Method, double>(triangle);
  } else {
    return Method::prepare(triangle);
  }
}

/// Where `ray` meets `triangle` with 0 < t < t_max, for all lanes of `V` at once. A ray parallel to the plane
/// misses, and so does one where anything is NaN or infinite, but for t_max.
template <class Method, Variant variant, class V>
[[nodiscard, gnu::always_inline]] inline Solution<V> solve_lanes(
    const Ray<V>& ray, const TriangleFor<Method, variant, V>& triangle, const V& t_max) {
  static_assert(applies<Method, V>(variant), "why_not says why");
  if constexpr (variant.data == Data::bare && has_constants<Method>) {
    constexpr Variant prepared = [] {
      Variant copy = variant;
      copy.data = Data::precomputed;
      return copy;
    }();
    return solve_lanes<Method, prepared, V>(ray, Method::prepare(triangle), t_max);
  } else {
    using Terms = TermsOf<Method, V>;
    const Terms terms(ray, triangle);
    if constexpr (variant.division == Division::early) {
      return decide<variant, V>(EarlyTest<variant, Terms, V>(terms, t_max));
    } else {
      return decide<variant, V>(LateTest<variant, Terms, V>(terms, t_max));
    }
  }
}

/// The same for one ray. What the variant was not asked for is NaN in the hit.
template <class Method, Variant variant, class V>
[[nodiscard, gnu::always_inline]] inline std::optional<TriangleHit<V>> solve(
    const Ray<V>& ray, const TriangleFor<Method, variant, V>& triangle, const V& t_max) {
  const Solution<V> solution = solve_lanes<Method, variant, V>(ray, triangle, t_max);
  if (!solution.accepted) return std::nullopt;
  return TriangleHit<V>{solution.t, solution.beta, solution.gamma};
}

}  // namespace raysweep
