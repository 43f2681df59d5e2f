#include "experiments/overhead/tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "experiments/overhead/numbers_text.h"
#include "experiments/overhead/task_sweep.h"
#include "schedulers/registry.h"

namespace raysweep {

namespace {

constexpr double bounds[] = {0.5, 0.95};

/// Beyond so much drift between the calibrations, efficiencies are off by as much as what 95 % is about.
constexpr double marked_drift = 0.025;

double at_once(const Subject& subject, int processors) { return std::min(subject.threads, processors); }

double drift(const OverheadRow& row) { return row.after.iteration / row.before.iteration - 1; }

std::string runtime_text(const Subject& subject) { return subject.runtime.empty() ? "–" : subject.runtime; }

Estimate nanoseconds(std::vector<double> seconds) {
  for (double& s : seconds) s *= 1e9;
  return estimate_median(std::move(seconds));
}

std::string region_text(const RowSamples& samples) {
  return samples.region_seconds.empty() ? "–" : duration_text(nanoseconds(samples.region_seconds));
}

std::string chunk_text(const OverheadRow& row, int processors) {
  if (!find_scheduler(row.subject.scheduler)->uses_chunk) return "–, no chunks";
  const auto cost = nanoseconds_per_chunk(row.samples, at_once(row.subject, processors));
  if (!cost) return "–";
  if (cost->interval && cost->interval->low <= 0)
    return fmt::format("≤ {}, within noise", duration_text(std::max(cost->interval->high, 0.0)));
  return duration_text(*cost);
}

std::string notes(const OverheadRow& row, int processors) {
  std::vector<std::string> notes;
  if (!row.problem.empty()) notes.push_back(row.problem);
  if (row.subject.threads > processors) notes.emplace_back("oversubscribed");
  const auto sizes = task_sizes(row, processors);
  if (!sizes.empty() && std::abs(drift(row)) > marked_drift) notes.emplace_back("drifted");
  const bool noisy = std::ranges::any_of(bounds, [&](double bound) {
    const auto metg = find_metg(sizes, bound);
    return metg && metg->noisy;
  });
  if (noisy) notes.emplace_back("efficiency goes up and down");
  return fmt::format("{}", fmt::join(notes, "; "));
}

/// The median; the cap where the process never went quiet.
std::string burn_text(const RowSamples& samples) {
  if (samples.burns.empty()) return "–";
  std::vector<double> cpu;
  bool quiet = true;
  for (const BurnSample& burn : samples.burns) {
    cpu.push_back(burn.cpu_seconds * 1e9);
    quiet = quiet && burn.went_quiet;
  }
  return duration_text(median(cpu)) + (quiet ? "" : ", and goes on after 1 s");
}

void add_cells(std::vector<std::string>& cells, const std::optional<Metg>& metg) {
  constexpr const char* kinds[] = {"bracketed", "at_most", "above"};
  cells.push_back(metg ? digits(metg->nanoseconds) : "");
  cells.emplace_back(metg ? kinds[static_cast<size_t>(metg->kind)] : "");
}

std::vector<Table::Column> columns(std::initializer_list<const char*> words,
                                   std::initializer_list<const char*> numbers) {
  std::vector<Table::Column> list;
  for (const char* title : words) list.push_back({title, false});
  for (const char* title : numbers) list.push_back({title});
  return list;
}

std::optional<Estimate> region_numbers(const RowSamples& samples) {
  if (samples.region_seconds.empty()) return std::nullopt;
  return nanoseconds(samples.region_seconds);
}

}  // namespace

std::optional<Estimate> nanoseconds_per_chunk(const RowSamples& samples, double useful_at_once) {
  if (samples.region_seconds.empty() || samples.chunks_seconds.empty() || samples.chunks <= 0)
    return std::nullopt;
  const Estimate region = nanoseconds(samples.region_seconds), run = nanoseconds(samples.chunks_seconds);
  const double scale = useful_at_once / samples.chunks;
  Estimate cost{(run.value - region.value) * scale, std::nullopt, run.count};
  if (region.interval && run.interval)
    cost.interval = {(run.interval->low - region.interval->high) * scale,
                     (run.interval->high - region.interval->low) * scale};
  return cost;
}

std::vector<TaskSize> task_sizes(const OverheadRow& row, int processors) {
  std::vector<TaskSize> sizes;
  for (const SizeSample& sample : row.samples.sizes) {
    const double task_ns =
        (row.before.nanoseconds(sample.iterations) + row.after.nanoseconds(sample.iterations)) / 2;
    sizes.push_back(
        {task_ns, efficiency(row.samples.tasks, task_ns, at_once(row.subject, processors), sample.seconds)});
  }
  return sizes;
}

Table scheduler_table(const std::vector<OverheadRow>& rows, int processors) {
  Table table;
  table.columns = columns({"scheduler", "runtime"}, {"threads", "empty region", "per chunk", "chunks/run",
                                                     "METG(50 %)", "METG(95 %)", "drift"});
  table.columns.push_back({"notes", false});
  for (const OverheadRow& row : rows) {
    const auto sizes = task_sizes(row, processors);
    table.rows.push_back(
        {row.subject.scheduler, runtime_text(row.subject), std::to_string(row.subject.threads),
         region_text(row.samples), chunk_text(row, processors),
         row.samples.chunks > 0 ? fmt::format("{:.0f}", row.samples.chunks) : "–",
         metg_text(find_metg(sizes, bounds[0])), metg_text(find_metg(sizes, bounds[1])),
         sizes.empty() ? "–" : fmt::format("{:+.1f} %", 100 * drift(row)), notes(row, processors)});
  }
  return table;
}

Table waiting_table(const std::vector<OverheadRow>& rows, int processors) {
  Table table;
  table.columns = columns({"scheduler", "runtime", "workers wait", "beside"},
                          {"threads", "empty region", "slowest repetition", "idle burn"});
  table.columns.push_back({"notes", false});
  for (const OverheadRow& row : rows) {
    const auto& regions = row.samples.region_seconds;
    table.rows.push_back({row.subject.scheduler, runtime_text(row.subject), row.subject.wait_text(),
                          row.subject.beside_load ? "a busy process" : "nothing",
                          std::to_string(row.subject.threads), region_text(row.samples),
                          regions.empty() ? "–" : duration_text(1e9 * *std::ranges::max_element(regions)),
                          burn_text(row.samples), notes(row, processors)});
  }
  return table;
}

Table scheduler_numbers(const std::vector<OverheadRow>& rows, int processors) {
  Table table;
  table.columns =
      columns({"scheduler", "runtime", "wait"},
              {"threads", "oversubscribed", "region_ns", "region_low_ns", "region_high_ns", "chunk_ns",
               "chunk_low_ns", "chunk_high_ns", "chunks_per_run", "metg50_ns", "metg50_kind", "metg95_ns",
               "metg95_kind", "call_ns", "iteration_ns_before", "iteration_ns_after", "notes"});
  for (const OverheadRow& row : rows) {
    const Subject& s = row.subject;
    std::vector<std::string> cells{s.scheduler, s.runtime, s.wait_text(), std::to_string(s.threads),
                                   s.threads > processors ? "1" : "0"};
    add_cells(cells, region_numbers(row.samples));
    add_cells(cells, nanoseconds_per_chunk(row.samples, at_once(s, processors)));
    cells.push_back(row.samples.chunks > 0 ? digits(row.samples.chunks) : "");
    for (const double bound : bounds) add_cells(cells, find_metg(task_sizes(row, processors), bound));
    for (const double ns : {row.before.call, row.before.iteration, row.after.iteration})
      cells.push_back(digits(ns));
    cells.push_back(notes(row, processors));
    table.rows.push_back(std::move(cells));
  }
  return table;
}

Table task_size_numbers(const std::vector<OverheadRow>& rows, int processors) {
  Table table;
  table.columns = columns({"scheduler", "runtime", "wait"},
                          {"threads", "tasks", "iterations", "task_ns", "run_ns", "efficiency"});
  for (const OverheadRow& row : rows) {
    const auto sizes = task_sizes(row, processors);
    for (size_t i = 0; i < sizes.size(); ++i) {
      const SizeSample& sample = row.samples.sizes[i];
      table.rows.push_back({row.subject.scheduler, row.subject.runtime, row.subject.wait_text(),
                            std::to_string(row.subject.threads), digits(row.samples.tasks),
                            digits(sample.iterations), digits(sizes[i].nanoseconds),
                            digits(1e9 * sample.seconds), digits(sizes[i].efficiency)});
    }
  }
  return table;
}

Table waiting_numbers(const std::vector<OverheadRow>& rows, int processors) {
  Table table;
  table.columns = columns({"scheduler", "runtime", "wait"},
                          {"beside_load", "threads", "oversubscribed", "region_ns", "region_low_ns",
                           "region_high_ns", "burn_cpu_ns", "went_quiet", "notes"});
  for (const OverheadRow& row : rows) {
    const Subject& s = row.subject;
    std::vector<std::string> cells{s.scheduler,
                                   s.runtime,
                                   s.wait_text(),
                                   s.beside_load ? "1" : "0",
                                   std::to_string(s.threads),
                                   s.threads > processors ? "1" : "0"};
    add_cells(cells, region_numbers(row.samples));
    std::vector<double> cpu;
    for (const BurnSample& burn : row.samples.burns) cpu.push_back(1e9 * burn.cpu_seconds);
    cells.push_back(cpu.empty() ? "" : digits(median(cpu)));
    cells.emplace_back(std::ranges::all_of(row.samples.burns, &BurnSample::went_quiet) ? "1" : "0");
    cells.push_back(notes(row, processors));
    table.rows.push_back(std::move(cells));
  }
  return table;
}

}  // namespace raysweep
