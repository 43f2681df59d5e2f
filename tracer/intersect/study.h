// The one list of the intersection study: every method that `solve` knows. The tracer's own are in all.h.
#pragma once

#include <tuple>

#include "tracer/intersect/angle_sum.h"
#include "tracer/intersect/badouel.h"
#include "tracer/intersect/baldwin_weber.h"
#include "tracer/intersect/half_spaces.h"
#include "tracer/intersect/havel_herout.h"
#include "tracer/intersect/keidy.h"
#include "tracer/intersect/kensler_shirley.h"
#include "tracer/intersect/moller_trumbore.h"
#include "tracer/intersect/morozov.h"
#include "tracer/intersect/perpendicular_planes.h"
#include "tracer/intersect/plucker.h"
#include "tracer/intersect/shevtsov.h"
#include "tracer/intersect/signed_areas.h"
#include "tracer/intersect/solve.h"
#include "tracer/intersect/wald.h"
#include "tracer/intersect/woop_watertight.h"

namespace raysweep {

using StudyMethods =
    std::tuple<MollerTrumbore, KenslerShirley, Morozov, Shevtsov, Badouel, Wald, Keidy, PerpendicularPlanes,
               Plucker, HalfSpaces, SignedAreas, AngleSum, WoopWatertight, BaldwinWeber, HavelHerout>;

/// Calls `visit(method)` with an object of each method of the study in turn.
template <class Visit>
void for_each_study_method(Visit&& visit) {
  std::apply([&](auto... method) { (visit(method), ...); }, StudyMethods{});
}

/// Calls `visit.template operator()<variant>()` for the base variant of `Method` and every one that differs
/// from it in one factor, as far as they apply to numbers of type `V`.
template <class Method, class V, class Visit>
void for_each_variant(Visit&& visit) {
  const auto at = [&]<size_t index>() {
    constexpr Variant variant = variant_star<Method>()[index];
    if constexpr (applies<Method, V>(variant)) visit.template operator()<variant>();
  };
  [&]<size_t... index>(std::index_sequence<index...>) { (at.template operator()<index>(), ...); }
  (std::make_index_sequence<variant_star<Method>().size()>());
}

/// The same for all that factors can be at once: as many as 288 of a method.
template <class Method, class V, class Visit>
void for_each_combination(Visit&& visit) {
  const auto at = [&]<size_t number>() {
    constexpr Variant variant = combination(number);
    if constexpr (applies<Method, V>(variant)) visit.template operator()<variant>();
  };
  // Row by row: Clang folds no more than 256 at once.
  constexpr size_t row_length = 16;
  static_assert(combination_count % row_length == 0);
  const auto row = [&]<size_t first, size_t... i>(std::index_sequence<first>, std::index_sequence<i...>) {
    (at.template operator()<first + i>(), ...);
  };
  [&]<size_t... r>(std::index_sequence<r...>) {
    (row(std::index_sequence<r * row_length>(), std::make_index_sequence<row_length>()), ...);
  }
  (std::make_index_sequence<combination_count / row_length>());
}

}  // namespace raysweep
