#include "experiments/kernel_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <numeric>
#include <set>
#include <utility>

#include "experiments/clock.h"
#include "experiments/errors.h"
#include "experiments/interrupt.h"
#include "experiments/kernel_bench.h"
#include "experiments/kernel_timer.h"
#include "experiments/progress.h"

namespace raysweep {

namespace {

/// What an earlier run left.
struct Finished {
  std::set<std::pair<std::string, int>> records;  // cell and round
  std::map<std::string, uint64_t> iterations;     // by cell: the same in each round
};

Finished read_finished(const RunFiles& files) {
  Finished finished;
  if (!files.holds_records()) return finished;
  try {
    for (const KernelRecord& record : read_kernel_records(files.records_file())) {
      finished.records.emplace(record.cell, record.round);
      if (record.iterations > 0) finished.iterations[record.cell] = record.iterations;
    }
  } catch (const RecordError& error) {
    throw RequestError(error.what());
  }
  return finished;
}

/// The cells in the order of one round: the same for the same seed, whatever was run before.
std::vector<size_t> order_of(int round, const KernelPlan& plan) {
  Random random(plan.measure.seed * 1000 + static_cast<uint64_t>(round));  // rounds are 1000 at most
  std::vector<size_t> order(plan.cells.size());
  std::iota(order.begin(), order.end(), size_t{0});
  for (size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[random.index(i)]);
  return order;
}

class KernelRun {
 public:
  KernelRun(const KernelExperiment& experiment, bool quiet)
      : plan_(experiment.plan),
        files_(*experiment.files),
        finished_(read_finished(files_)),
        bench_(plan_),
        start_(now_seconds()),
        progress_("records", start_, plan_.measure.budget_seconds, quiet),
        total_(record_count(plan_) - finished_.records.size()) {
    report_.records = finished_.records.size();
  }

  [[nodiscard]] KernelReport run() {
    try {
      for (int round = 0; round < plan_.measure.rounds && report_.end == KernelEnd::complete; ++round)
        run_round(round);
    } catch (const WorkError& error) {
      report_.end = KernelEnd::failed;
      report_.failure = error.what();
    }
    return report_;
  }

 private:
  void run_round(int round) {
    for (const size_t index : order_of(round, plan_)) {
      const KernelCell& cell = plan_.cells[index];
      if (finished_.records.contains({cell.key, round})) continue;
      if (interrupted()) report_.end = KernelEnd::interrupted;
      if (now_seconds() - start_ > plan_.measure.budget_seconds) report_.end = KernelEnd::out_of_budget;
      if (report_.end != KernelEnd::complete) return;
      progress_.show(static_cast<int>(done_++), static_cast<int>(total_), now_seconds(), cell.key);
      keep(bench_.measure(cell, round, finished_.iterations[cell.key]));
    }
  }

  void keep(const KernelRecord& record) {
    files_.append_text(to_line(record) + "\n", "records");
    finished_.iterations[record.cell] = record.iterations;
    ++report_.records;
    if (record.valid) return;
    if (report_.void_records++ == 0) report_.first_void = record.cell + ": " + record.reason;
  }

  const KernelPlan& plan_;
  RunFiles& files_;
  Finished finished_;
  KernelBench bench_;
  double start_;
  Progress progress_;
  size_t done_ = 0, total_;
  KernelReport report_;
};

}  // namespace

KernelExperiment open_kernels(const KernelConfig& config, const std::filesystem::path& folder,
                              const Machine& machine, bool resume) {
  if (const std::string reason = why_no_kernel_timer(); !reason.empty())
    throw RequestError(fmt::format("{}: {}", config.file, reason));
  KernelExperiment experiment{make_plan(config), nullptr};
  const RunPapers papers{config.text, to_json(experiment.plan)};
  experiment.files = std::make_unique<RunFiles>(folder, papers, machine, resume);
  return experiment;
}

KernelReport run_kernels(const KernelExperiment& experiment, bool quiet) {
  return KernelRun(experiment, quiet).run();
}

double estimate_seconds(const KernelPlan& plan) {
  // Google Benchmark aims at 1.4 times the least time; two passes more compare hits and warm up, and those
  // that find out how many passes there are come once: as much as half a sample.
  constexpr double share = 1.4, more = 0.5;
  const auto& m = plan.measure;
  double round = 0;
  for (const KernelCell& cell : plan.cells) {
    const double pass = cell.small ? cell.small->rough_seconds(cell.values) : 0;
    round += std::max(share * m.min_seconds, pass) * m.samples + more * m.min_seconds + 2 * pass;
  }
  return std::min(m.budget_seconds, round * m.rounds);
}

std::string plan_as_text(const KernelPlan& plan) {
  const auto& m = plan.measure;
  std::string text = fmt::format(
      "{}: {}\n{} cells in {} rounds of {} samples of {:g} ms or more each; seed {}\n", plan.experiment,
      plan.title, plan.cells.size(), m.rounds, m.samples, m.min_seconds * 1000, m.seed);
  for (const KernelCell& cell : plan.cells) text += cell.key + "\n";
  for (const Inapplicable& one : plan.left_out)
    text += fmt::format("left out: {} {} {}: {}\n", one.method, one.change, one.precision, one.reason);
  return text;
}

}  // namespace raysweep
