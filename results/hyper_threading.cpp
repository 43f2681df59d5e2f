#include "results/hyper_threading.h"

#include <algorithm>
#include <set>

#include "results/factors.h"
#include "results/rounds.h"

namespace raysweep {

namespace {

/// As many cores as threads, and no second hardware thread.
bool is_one_each(const Record& r) {
  return r.is_bound() && r.cores_seen > 0 && r.threads == r.cores_seen && r.threads == r.processors_seen;
}

/// Two hardware threads of each core.
bool is_two_each(const Record& r) {
  return r.is_bound() && r.cores_seen > 0 && r.threads == 2 * r.cores_seen && r.threads == r.processors_seen;
}

/// The factors in which the cells of a group agree.
std::string key_without_threads_and_pin(const Record& r) {
  std::string key;
  for (const FactorText& f : factor_texts()) {
    if (f.name != "threads" && f.name != "pin") key += f.text(r) + "|";
  }
  return key;
}

std::set<int> processors_of(const Record& r) {
  std::set<int> processors;
  for (const WorkerRecord& w : r.workers) {
    if (w.cpu >= 0) processors.insert(w.cpu);
  }
  return processors;
}

/// The first row by `is_placed` with `threads` threads, equal to `whole` in the rest and on some of its
/// processors; null if there is none.
const CellRow* find_within(const std::vector<CellRow>& rows, const CellRow& whole, int threads,
                           bool (*is_placed)(const Record&)) {
  const auto processors = processors_of(whole.cell);
  const auto found = std::ranges::find_if(rows, [&](const CellRow& row) {
    return row.cell.threads == threads && is_placed(row.cell) &&
           key_without_threads_and_pin(row.cell) == key_without_threads_and_pin(whole.cell) &&
           std::ranges::includes(processors, processors_of(row.cell));
  });
  return found == rows.end() ? nullptr : &*found;
}

std::optional<Estimate> fps_ratio(const CellRow& of, const CellRow& base) {
  return paired(of.fps_by_round, base.fps_by_round,
                [](double own, double other) { return std::optional(own / other); });
}

/// Corrected for all that the table compares.
void add_changes(std::vector<HyperThreadingGroup>& groups) {
  size_t comparisons = groups.size();
  for (const auto& group : groups) comparisons += group.packed != nullptr;
  const double confidence = simultaneous_confidence(comparisons);
  for (auto& group : groups) {
    const auto change = [&](const CellRow& row) {
      return paired_change(log_ratios(row.fps_by_round, group.one_each->fps_by_round), confidence);
    };
    group.yield_change = change(*group.two_each);
    if (group.packed) group.packing_change = change(*group.packed);
  }
}

}  // namespace

std::vector<HyperThreadingGroup> hyper_threading_groups(const std::vector<CellRow>& rows) {
  std::vector<HyperThreadingGroup> groups;
  for (const CellRow& row : rows) {
    if (!is_two_each(row.cell)) continue;
    const int cores = row.cell.cores_seen;
    const CellRow* const one_each = find_within(rows, row, cores, is_one_each);
    if (!one_each) continue;
    HyperThreadingGroup group{one_each, &row, find_within(rows, row, cores, is_two_each), {}, {}, {}, {}};
    group.yield = fps_ratio(row, *one_each);
    if (group.packed) group.packing_penalty = fps_ratio(*group.packed, *one_each);
    groups.push_back(group);
  }
  add_changes(groups);
  return groups;
}

std::optional<double> hardware_thread_efficiency(const CellRow& row) {
  return row.speedup ? std::optional(row.speedup->value / row.cell.processors_seen) : std::nullopt;
}

}  // namespace raysweep
