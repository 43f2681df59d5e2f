// How wrong a method is on one ray, by the oracle.
#pragma once

#include <array>
#include <string_view>
#include <tuple>
#include <vector>

#include "experiments/intersection/judged.h"

namespace raysweep {

/// What of an answer may be wrong. `leak`: a ray passes between two triangles that lie on either side of a
/// shared edge, which it meets away from its ends.
enum class Wrong { false_miss, false_hit, t_error, weight_error, leak };
inline constexpr std::array<std::string_view, 5> wrong_names = {"false_miss", "false_hit", "t_error",
                                                                "weight_error", "leak"};

/// Which inputs count. `any`: all finite ones. `tame`: those without an excuse, where sizes and distances are
/// of one magnitude, so that what fails is the formula: coordinates up to 8, directions of a length from 1/2
/// to 2, longest edges of at least 1/4, altitudes of at least 1/8 of them, at least 1/8 off the plane by
/// sine, and at least 1/4 from the origin to the plane's point.
enum class Domain { tame, any };
inline constexpr std::array<std::string_view, 2> domain_names = {"tame", "any"};

/// A ray and one triangle, or for leaks two that share an edge.
template <class T>
struct Question {
  Ray<T> ray;
  std::vector<Triangle<T>> triangles;
};

/// Whether something is wrong, then by how much: of a false miss or hit and of a leak, how far the exact
/// weights are from the edge that decides, as a share of the triangle, and with nothing wrong the negative of
/// that, so that 0 is next to failing; of t in ε·t*, of weights in ε.
struct Badness {
  bool is_wrong = false;
  double how_much = 0;

  friend bool operator==(const Badness&, const Badness&) = default;
  friend bool operator<(const Badness& a, const Badness& b) {
    return std::tie(a.is_wrong, a.how_much) < std::tie(b.is_wrong, b.how_much);
  }
  friend bool operator>(const Badness& a, const Badness& b) { return b < a; }
};

/// Less than all others: the question does not ask for what is looked for.
[[nodiscard]] Badness not_asked();

template <class T>
[[nodiscard]] bool is_in(Domain domain, const Question<T>& question);

/// `hits` are the method's of the question's triangles, without an end of the ray.
template <class T>
[[nodiscard]] Badness badness_of(Wrong what, const Question<T>& question, const Hits<T>& hits);

}  // namespace raysweep
