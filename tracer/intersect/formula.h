// What the intersection study asks of a method: its formula, over any type of numbers.
#pragma once

#include <concepts>
#include <string_view>

#include "tracer/intersect/intersector.h"
#include "tracer/intersect/value.h"

namespace raysweep {

/// When a test divides: before it compares, as Wald 2004, or only what is hit, as Havel & Herout 2010.
enum class Division { early, late };
/// What is compared first.
enum class Order { distance_first, weights_first };

/// The members of every method of the study; `Prepared<V>` are the constants of a triangle (`Triangle<V>`
/// itself where there are none to compute), `division` and `order` are those of its source, `gives_weights`
/// tells whether it finds β and γ or only their signs.
template <class M, class V>
concept Described = requires(const Triangle<V>& triangle) {
  { M::name } -> std::convertible_to<std::string_view>;
  { M::summary } -> std::convertible_to<std::string_view>;
  { M::is_watertight } -> std::convertible_to<bool>;
  { M::gives_weights } -> std::convertible_to<bool>;
  { M::division } -> std::convertible_to<Division>;
  { M::order } -> std::convertible_to<Order>;
  { M::prepare(triangle) } -> std::same_as<typename M::template Prepared<V>>;
};

template <class M, class V>
using TermsOf = typename M::template Terms<V>;

/// `Terms(ray, prepared)` of every method: the ray meets the plane at t = `t()` / `det()`. Functions of terms
/// are pure, each computes what it needs: compilers find what they have in common, and what is not asked for
/// costs nothing.
template <class M, class V>
concept MeetsPlane = requires(const TermsOf<M, V>& terms) {
  { terms.det() } -> std::same_as<V>;
  { terms.t() } -> std::same_as<V>;
};

/// β = `beta()` / `det()`, likewise γ: Cramer's rule.
template <class M, class V>
concept Ratios = MeetsPlane<M, V> && requires(const TermsOf<M, V>& terms) {
  { terms.beta() } -> std::same_as<V>;
  { terms.gamma() } -> std::same_as<V>;
};

/// `at(t, w)` is the point `w·O + t·D`, as the method sees it; its weights are linear in (t, w). With (t, 1)
/// β = `beta()` / `whole()`; with (t(), det()) that is β·det: so such a method divides early or late.
/// `whole()` is a constant of the triangle; without it β = `beta()`.
template <class M, class V>
concept PlaneFirst = MeetsPlane<M, V> && requires(const TermsOf<M, V>& terms, const V& v) {
  { terms.at(v, v).beta() } -> std::same_as<V>;
  { terms.at(v, v).gamma() } -> std::same_as<V>;
};

/// `encloses(t)`: whether the point at t is inside. Neither weights nor signs.
template <class M, class V>
concept Encloses = MeetsPlane<M, V> && requires(const TermsOf<M, V>& terms, const V& v) {
  terms.encloses(v);
};

/// A method of the study. Ratios and points may have `alpha()` too, the weight of A: then its sign is
/// compared, else β + γ with 1.
template <class M, class V>
concept Formula = Described<M, V> &&(Ratios<M, V> || PlaneFirst<M, V> || Encloses<M, V>);

/// Constants computed in `Wide` and rounded to `V` once.
template <class Method, class Wide, class V>
[[nodiscard]] typename Method::template Prepared<V> prepare_in(const Triangle<V>& triangle) {
  return Method::prepare(triangle.template as<Wide>()).template as<V>();
}

/// Whether a method has constants to compute ahead.
template <class Method>
constexpr bool has_constants = !std::same_as<typename Method::template Prepared<float>, Triangle<float>>;

}  // namespace raysweep
