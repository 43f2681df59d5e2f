// One method in different arrangements: the factors of the study, each a compile-time parameter.
#pragma once

#include <array>
#include <string_view>

#include "tracer/intersect/formula.h"

namespace raysweep {

/// How 1/det is found: by division, or by the processor's estimate y and one step of Newton's, 2y − det·y².
enum class Reciprocal { exact, newton };
/// Whether edges and corners belong to the triangle.
enum class Edges { inclusive, strict };
/// Whether a test ends at the first comparison that fails; if not, all is computed and decided at the end.
/// `folded`: decided by no branch at all, but within t, as Morozov 2011, listing 1, returns it: b·t + b − 1,
/// where b is 1 or 0, and what is negative is a miss. A t that is infinite or NaN makes that NaN, a false
/// hit; and t is as coarse as t + 1.
enum class EarlyOut { yes, no, folded };
/// What is asked for. A hit that is asked for t has no weights, one not asked for t has neither.
enum class Output { hit, t, weights };
/// Whether constants are computed within each test or ahead; `from_double`: ahead, in double, and rounded to
/// float once.
enum class Data { bare, precomputed, from_double };

struct Variant {
  Division division = Division::early;
  Reciprocal reciprocal = Reciprocal::exact;
  Order order = Order::distance_first;
  Edges edges = Edges::inclusive;
  EarlyOut early_out = EarlyOut::yes;
  Output output = Output::weights;
  Data data = Data::precomputed;

  friend constexpr bool operator==(const Variant&, const Variant&) = default;
};

/// The method as its source has it, with all that it can give.
template <class Method>
[[nodiscard]] constexpr Variant base_variant() {
  Variant base;
  base.division = Method::division;
  base.order = Method::order;
  base.output = Method::gives_weights ? Output::weights : Output::t;
  base.data = has_constants<Method> ? Data::precomputed : Data::bare;
  return base;
}

/// Why `variant` of `Method` over numbers of type `V` does not exist, a clause; empty if it does.
template <class Method, class V>
[[nodiscard]] constexpr std::string_view why_not(Variant variant) {
  if (!Formula<Method, V>) return "the method needs angles, which these numbers do not have";
  if (variant.data != Data::bare && !has_constants<Method>)
    return "the method has no constants to compute ahead";
  if (variant.data == Data::from_double && !std::same_as<V, float>)
    return "there are no wider numbers to round constants from";
  if (variant.output == Output::weights && !Method::gives_weights)
    return "the method finds no weights, only whether the point is inside";
  if (variant.order == Order::weights_first && !Ratios<Method, V>)
    return "the method looks for the point first, which is the distance";
  if (variant.division == Division::late && Encloses<Method, V>)
    return "a sum of angles cannot be scaled: the point must be known";
  if (variant.edges == Edges::strict && Encloses<Method, V>)
    return "a sum of angles within a tolerance has no edges to leave out";
  if (variant.reciprocal == Reciprocal::newton && !requires(V x) { approximate_reciprocal(x); })
    return "the processor has no estimate of reciprocals of these numbers";
  if (variant.reciprocal == Reciprocal::newton && variant.division == Division::late &&
      variant.output == Output::hit)
    return "nothing is divided";
  if (variant.early_out == EarlyOut::folded && variant.output == Output::hit)
    return "the decision is folded into t, which is not asked for";
  return "";
}

template <class Method, class V>
[[nodiscard]] constexpr bool applies(Variant variant) {
  return why_not<Method, V>(variant).empty();
}

/// The base variant, then every variant that differs from it in one factor: whether they apply or not.
template <class Method>
[[nodiscard]] constexpr auto variant_star() {
  constexpr Variant base = base_variant<Method>();
  std::array<Variant, 11> star;
  star.fill(base);
  star[1].division = base.division == Division::early ? Division::late : Division::early;
  star[2].reciprocal = Reciprocal::newton;
  star[3].order = base.order == Order::distance_first ? Order::weights_first : Order::distance_first;
  star[4].edges = Edges::strict;
  star[5].early_out = EarlyOut::no;
  star[6].output = Output::hit;
  star[7].output = base.output == Output::weights ? Output::t : Output::weights;
  star[8].data = base.data == Data::bare ? Data::precomputed : Data::bare;
  star[9].early_out = EarlyOut::folded;
  star[10].data = Data::from_double;
  return star;
}

/// How many variants there are if all factors change at once. Constants from double are not among them: a
/// test does not know where they come from.
constexpr size_t combination_count = size_t{2} * 2 * 2 * 2 * 2 * 3 * 3;

/// The one of this number, below `combination_count`: whether it applies to a method or not.
[[nodiscard]] constexpr Variant combination(size_t number) {
  const auto take = [&](size_t count) {
    const size_t digit = number % count;
    number /= count;
    return digit;
  };
  Variant variant;
  variant.division = Division(take(2));
  variant.reciprocal = Reciprocal(take(2));
  variant.order = Order(take(2));
  variant.edges = Edges(take(2));
  variant.data = Data(take(2));
  variant.early_out = EarlyOut(take(3));
  variant.output = Output(take(3));
  return variant;
}

}  // namespace raysweep
