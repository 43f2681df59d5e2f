// The worst inputs that were found for each method, as lines of a file: numbers in hexadecimal, so that none
// is rounded.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "experiments/intersection/search.h"

namespace raysweep {

/// A method as it is asked for its worst inputs. `change` is "base", or "intersect" for the tracer's own
/// function of that name, which may be surer than the study's formula.
template <class T>
struct Suspect {
  std::string method, change;
  bool gives_weights = true;
  Finder<T> find;
};

/// The base variants of the study and the tracer's methods. Without `angle_sum`: its arc tangents are the C
/// library's own, and so would be its worst inputs.
template <class T>
[[nodiscard]] const std::vector<Suspect<T>>& all_suspects();

/// The worst input of one suspect.
struct WorstInput {
  std::string method, change, precision;
  Wrong what{};
  Domain domain{};
  std::string verdict;          // the oracle's: "hit", "miss" or "boundary"; of a leak two, "hit miss"
  std::string how_wrong;        // six digits of Badness::how_much
  std::vector<double> numbers;  // origin, direction, then the corners of each triangle
};

/// Searches; only what is wrong is a worst input, and else there is none.
[[nodiscard]] std::vector<WorstInput> worst_inputs(const SearchSettings& settings);

/// What is now true of a worst input's numbers: `verdict` and `how_wrong` as they would be written, the
/// latter "right" if the method has got better. Throws std::out_of_range for an unknown suspect.
[[nodiscard]] WorstInput judged_anew(const WorstInput& input);

inline constexpr std::string_view worst_inputs_head =
    "method,change,precision,what,domain,verdict,how_wrong,numbers";
/// One line of the file without its end.
[[nodiscard]] std::string to_line(const WorstInput& input);
/// Throws std::runtime_error, with file and line, for what is no such file.
[[nodiscard]] std::vector<WorstInput> read_worst_inputs(const std::filesystem::path& file);

}  // namespace raysweep
