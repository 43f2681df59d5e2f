// From a cell of a kernel experiment to its record.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "experiments/kernel_plan.h"
#include "results/kernel_record.h"

namespace raysweep {

struct KnownHits;
struct BenchTests;

/// What is wrong with a number of hits, a clause; empty if nothing is. Of tests that are `known` kernels find
/// all hits that are clear and may find each that is not; `base` are those that the method's base kernel
/// found.
[[nodiscard]] std::string why_wrong(uint64_t hits, uint64_t base, const KnownHits& known);

/// Makes the tests of a plan when they are asked for first, and keeps them.
class KernelBench {
 public:
  /// `plan` must outlive it.
  explicit KernelBench(const KernelPlan& plan);
  ~KernelBench();
  KernelBench(const KernelBench&) = delete;
  KernelBench& operator=(const KernelBench&) = delete;

  /// Compares hits, then times. `iterations`: passes a sample, 0 if they are to be found out.
  [[nodiscard]] KernelRecord measure(const KernelCell& cell, int round, uint64_t iterations);

 private:
  const KernelPlan& plan_;
  std::vector<std::unique_ptr<BenchTests>> tests_;  // as the plan's, null until asked for
};

}  // namespace raysweep
