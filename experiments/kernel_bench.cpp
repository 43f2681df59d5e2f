#include "experiments/kernel_bench.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

#include "experiments/intersection/replay.h"
#include "experiments/kernel_timing.h"
#include "experiments/scheduled_pass.h"
#include "experiments/small_kernel_bench.h"

namespace raysweep {

/// A list of tests in both precisions, and what is known of it.
struct BenchTests {
  explicit BenchTests(const Workload<float>& work)
      : in_float(work), in_double(work_in<double>(work)), known(known_hits(work)) {}

  template <class T>
  [[nodiscard]] const Workload<T>& in() const {
    if constexpr (std::is_same_v<T, float>)
      return in_float;
    else
      return in_double;
  }

  Workload<float> in_float;
  Workload<double> in_double;
  KnownHits known;
  std::map<std::pair<Precision, std::string_view>, uint64_t> base_hits;  // by method
};

namespace {

/// A kernel for each of several shares of the tests.
template <class T>
class SharedPasses {
 public:
  SharedPasses(const Kernel<T>& kernel, const Workload<T>& work, int shares) {
    shares_.reserve(static_cast<size_t>(shares));  // passes point into it
    for (int share = 0; share < shares; ++share) {
      if (shares > 1)
        shares_.push_back(share_of(work, static_cast<uint32_t>(share), static_cast<uint32_t>(shares)));
      passes_.push_back(kernel.prepare(shares > 1 ? shares_.back() : work));
    }
  }

  [[nodiscard]] std::vector<TimedPass> timed() const {
    std::vector<TimedPass> list;
    for (const auto& pass : passes_) {
      list.emplace_back([one = pass.get()] {
        const PassResult found = one->run();
        return found.sum + static_cast<double>(found.hits);
      });
    }
    return list;
  }
  [[nodiscard]] uint64_t hits() const {
    uint64_t sum = 0;
    for (const auto& pass : passes_) sum += pass->run().hits;
    return sum;
  }

 private:
  std::vector<Workload<T>> shares_;
  std::vector<std::unique_ptr<KernelPass>> passes_;
};

VariantRecord record_of(const Variant& variant) {
  VariantRecord record;
  const auto names = factor_names(variant);
  std::string* const values[] = {&record.division,  &record.reciprocal, &record.order, &record.edges,
                                 &record.early_out, &record.output,     &record.data};
  for (size_t i = 0; i < names.size(); ++i) *values[i] = names[i].value;
  return record;
}

/// All that is known before anything runs.
template <class T>
KernelRecord describe(const KernelPlan& plan, const KernelCell& cell, int round) {
  const Kernel<T>& kernel = all_kernels<T>()[cell.kernel];
  const KernelTests& tests = plan.tests[cell.tests];
  KernelRecord r;
  r.experiment = plan.experiment;
  r.cell = cell.key;
  r.round = round;
  r.seed = plan.measure.seed;
  r.kernel = "intersection";
  r.method = kernel.method;
  r.change = kernel.change;
  r.variant = record_of(kernel.variant);
  r.precision = name_of(cell.precision);
  r.rays_at_once = static_cast<int>(kernel.rays);
  r.triangles_at_once = static_cast<int>(kernel.triangles);
  r.layout = kernel.layout;
  r.contraction = kernel.contraction;
  r.compiler = kernel.compiler;
  r.isa = kernel.isa;
  r.bytes = kernel.bytes;
  r.protocol = tests.protocol->name;
  r.parameter = tests.parameter;
  r.scene = tests.scene;
  r.threads = cell.threads;
  r.scheduler = cell.scheduler;
  return r;
}

/// Each thread its share, or all shares by the cell's scheduler.
Timing time_shares(const KernelCell& cell, const std::vector<TimedPass>& shares,
                   const TimingRequest& request) {
  if (cell.scheduler == own_shares) return time_passes(shares, request);
  ScheduledPass pass(cell.scheduler, cell.threads, shares);
  return time_passes({[&] { return pass.run(); }}, request);
}

/// Found once for each method.
template <class T>
uint64_t base_hits(BenchTests& tests, Precision precision, std::string_view method) {
  const auto found = tests.base_hits.find({precision, method});
  if (found != tests.base_hits.end()) return found->second;
  const auto& kernels = all_kernels<T>();
  const auto base = std::find_if(kernels.begin(), kernels.end(), [&](const Kernel<T>& one) {
    return one.method == method && one.change == "base";
  });
  return tests.base_hits[{precision, method}] = base->prepare(tests.in<T>())->run().hits;
}

template <class T>
KernelRecord measure_in(const KernelPlan& plan, BenchTests& tests, const KernelCell& cell, int round,
                        uint64_t iterations) {
  const Kernel<T>& kernel = all_kernels<T>()[cell.kernel];
  const int shares = cell.scheduler == own_shares ? cell.threads : parts_a_thread * cell.threads;
  const SharedPasses<T> shared(kernel, tests.in<T>(), shares);
  KernelRecord record = describe<T>(plan, cell, round);
  record.tests = tests.in<T>().test_count();
  const uint64_t hits = shared.hits(), of_base = base_hits<T>(tests, cell.precision, kernel.method);
  record.hit_rate = static_cast<double>(hits) / static_cast<double>(record.tests);
  record.reason = why_wrong(hits, of_base, tests.known);
  record.valid = record.reason.empty();
  if (!record.valid) return record;
  set_timing(record, time_shares(cell, shared.timed(), timing_request(plan, cell, iterations)));
  return record;
}

}  // namespace

std::string why_wrong(uint64_t hits, uint64_t base, const KnownHits& known) {
  if (hits < known.hits || hits > known.hits + known.unclear)
    return fmt::format("{} hits, where {} are certain and {} tests are unclear", hits, known.hits,
                       known.unclear);
  if (std::max(hits, base) - std::min(hits, base) > known.unclear)
    return fmt::format("{} hits, where the base kernel has {} and {} tests are unclear", hits, base,
                       known.unclear);
  return {};
}

KernelBench::KernelBench(const KernelPlan& plan) : plan_(plan), tests_(plan.tests.size()) {}
KernelBench::~KernelBench() = default;

KernelRecord KernelBench::measure(const KernelCell& cell, int round, uint64_t iterations) {
  if (cell.small) return measure_small_kernel(plan_, cell, round, iterations);
  auto& tests = tests_[cell.tests];
  if (!tests) {
    const KernelTests& asked = plan_.tests[cell.tests];
    tests = std::make_unique<BenchTests>(asked.protocol->has_scene
                                             ? replay_work(asked.scene, plan_.measure.seed)
                                             : asked.protocol->make(asked.parameter, plan_.measure.seed));
  }
  return cell.precision == Precision::float_precision
             ? measure_in<float>(plan_, *tests, cell, round, iterations)
             : measure_in<double>(plan_, *tests, cell, round, iterations);
}

}  // namespace raysweep
