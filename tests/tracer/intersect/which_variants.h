// How many of a method's variants a test goes through.
#pragma once

#include "tracer/intersect/study.h"

namespace raysweep {

/// `base`: the method as its source has it; `star`: besides, all that differ from it in one factor.
enum class WhichVariants { base, star };

/// Calls `visit.template operator()<variant>()`.
template <WhichVariants which, class Method, class V, class Visit>
void for_each_variant_of(Visit&& visit) {
  if constexpr (which == WhichVariants::base) {
    visit.template operator()<base_variant<Method>()>();
  } else {
    for_each_variant<Method, V>(visit);
  }
}

}  // namespace raysweep
