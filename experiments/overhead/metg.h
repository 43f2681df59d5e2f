// METG, the minimum effective task granularity: the smallest task that a run can be cut into and still keep
// an efficiency (Slaughter et al. 2020, "Task Bench: A Parameterized Benchmark for Evaluating Parallel
// Runtime Performance", section IV). Pure functions of what was measured.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace raysweep {

/// A size of task that was tried. Efficiency is useful time over all time, both summed over processors.
struct TaskSize {
  double nanoseconds, efficiency;
};

struct Metg {
  enum class Kind {
    bracketed,  // a size below the bound was measured, and all larger ones reached it
    at_most,    // every size reached the bound: the smallest one is given
    above       // the largest size did not: it is given
  };
  Kind kind;
  double nanoseconds;
  bool noisy = false;  // a smaller size than the last one below the bound had reached it
};

/// Where efficiency crosses `bound` for good, interpolated between the two sizes around it: linear in
/// efficiency, logarithmic in size, as the sizes are spaced. None without sizes. `sizes` in any order.
[[nodiscard]] std::optional<Metg> find_metg(std::vector<TaskSize> sizes, double bound);

/// "1.234 µs", "not bracketed (≤ 6.100 ns)", "not bracketed (> 2.000 ms)".
[[nodiscard]] std::string metg_text(const std::optional<Metg>& metg);

}  // namespace raysweep
