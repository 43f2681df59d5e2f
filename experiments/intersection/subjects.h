// Every method of the study in every variant, as functions over whole batches: what is measured is one list.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/intersection/judged.h"
#include "experiments/intersection/variant_names.h"
#include "tracer/intersect/variant.h"

namespace raysweep {

/// A method in one variant over numbers of type `T`, float or double.
template <class T>
struct Subject {
  std::string_view method;
  std::string change;  // what differs from the method's base variant: "division=late"; "base" for itself
  Variant variant;
  std::function<Hits<T>(const Trials<T>&)>
      find_hits;          // constants of triangles are computed ahead or in each test
  bool combines = false;  // whether several factors differ at once: none of the star
};

/// A variant that a method does not have, and why not.
struct Inapplicable {
  std::string_view method;
  std::string change;
  std::string_view precision;
  std::string reason;
};

/// The names of the methods, in the order of the study's list.
[[nodiscard]] const std::vector<std::string_view>& study_method_names();

/// Of each method its base variant, then those that differ from it in one factor, as far as they apply.
template <class T>
[[nodiscard]] const std::vector<Subject<T>>& all_subjects();

/// Those that do not, of both precisions.
[[nodiscard]] const std::vector<Inapplicable>& inapplicable_subjects();

}  // namespace raysweep
