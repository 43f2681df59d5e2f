// The worst inputs of a method: climbs from rays of the catalogue, a few ulps at a time, to where it is more
// wrong.
#pragma once

#include <functional>
#include <optional>

#include "experiments/intersection/badness.h"

namespace raysweep {

/// What a method says of each candidate of trials; `Subject::find_hits` is one.
template <class T>
using Finder = std::function<Hits<T>(const Trials<T>& trials)>;

struct SearchSettings {
  Wrong what{};
  Domain domain{};
  uint64_t seed = 1;
  size_t starts = 8;        // rays of the catalogue, each climbed from
  size_t mutants = 24;      // tried at each step, of which the worst is next
  size_t patience = 50;     // steps that may find nothing worse
  size_t most_steps = 400;  // of one climb
};

template <class T>
struct Worst {
  Question<T> question;
  Badness badness;
};

/// The same for the same settings on every machine with the same long double. None if no start asks for
/// what is looked for.
template <class T>
[[nodiscard]] std::optional<Worst<T>> search_worst(const Finder<T>& finder, const SearchSettings& settings);

}  // namespace raysweep
