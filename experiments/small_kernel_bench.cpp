#include "experiments/small_kernel_bench.h"

#include "experiments/intersection/compiler_name.h"
#include "experiments/kernel_timing.h"

namespace raysweep {

namespace {

// Passes that find everything disturbed are short, and what disturbs is long: as many as a second has room
// for, whatever they take themselves.
constexpr uint64_t disturbed_passes = 10;

KernelRecord describe(const KernelPlan& plan, const KernelCell& cell, int round) {
  KernelRecord r;
  r.experiment = plan.experiment;
  r.cell = cell.key;
  r.round = round;
  r.seed = plan.measure.seed;
  r.kernel = cell.small->name;
  r.factors = cell.values;
  r.compiler = compiler_name;
  r.isa = "baseline";
  return r;
}

}  // namespace

KernelRecord measure_small_kernel(const KernelPlan& plan, const KernelCell& cell, int round,
                                  uint64_t iterations) {
  const std::unique_ptr<SmallPass> pass = cell.small->prepare(cell.values, plan.measure.seed);
  KernelRecord record = describe(plan, cell, round);
  record.tests = pass->operations();
  record.reason = pass->why_wrong();
  record.valid = record.reason.empty();
  if (!record.valid) return record;
  record.ticks = pass->ticks();
  TimingRequest request = timing_request(plan, cell, iterations);
  if (pass->is_disturbed()) {
    request.iterations = disturbed_passes;
    request.before = [&] { pass->disturb(); };
  }
  set_timing(record, time_passes({[&] { return pass->run(); }}, request));
  return record;
}

}  // namespace raysweep
