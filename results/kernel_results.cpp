#include "results/kernel_results.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "results/plan_file.h"

namespace raysweep {

namespace {

void add_once(std::vector<std::string>& list, const std::string& value) {
  if (std::find(list.begin(), list.end(), value) == list.end()) list.push_back(value);
}

void add_ticks(std::map<std::string, std::map<int, double>>& ticks, int round, const TickRecord& record) {
  ticks["min"][round] = record.min;
  ticks["avg"][round] = record.avg;
  ticks["max"][round] = record.max;
  ticks["sum"][round] = record.sum;
}

std::string key_of(const std::string& method, const std::string& change, const std::string& precision,
                   const std::string& tests) {
  return fmt::format("{}/{}/{}/{}", method, change, precision, tests);
}

/// Records by the place of their cell in the plan; of those that it does not have, last.
std::vector<KernelRecord> in_order_of(const std::vector<std::string>& cells,
                                      std::vector<KernelRecord> records) {
  std::map<std::string, size_t> places;
  for (const std::string& cell : cells) places.emplace(cell, places.size());
  const auto place = [&](const KernelRecord& record) {
    const auto found = places.find(record.cell);
    return found == places.end() ? places.size() : found->second;
  };
  std::stable_sort(records.begin(), records.end(),
                   [&](const KernelRecord& a, const KernelRecord& b) { return place(a) < place(b); });
  return records;
}

}  // namespace

Estimate median_of(const std::map<int, double>& by_round) {
  std::vector<double> samples;
  for (const auto& [round, value] : by_round) samples.push_back(value);
  return estimate_median(std::move(samples));
}

double nanoseconds_a_test(const KernelRecord& r) {
  return 1e9 * median(r.seconds) / (static_cast<double>(r.iterations) * static_cast<double>(r.tests));
}

std::string tests_of(const KernelRecord& r) {
  std::string text = r.protocol;
  if (!std::isnan(r.parameter)) text += fmt::format(" {:g}", r.parameter);
  if (!r.scene.empty()) text += ' ' + r.scene;
  if (r.scheduler != own_shares) text += ", " + r.scheduler;
  if (r.threads != 1) text += fmt::format(", {} threads", r.threads);
  return text;
}

bool KernelRatio::shows_difference() const {
  return estimate.interval && (estimate.interval->low > 1 || estimate.interval->high < 1);
}

KernelCellResult& KernelResults::cell_of(const KernelRecord& r) {
  std::string key = r.cell;
  if (r.is_intersection()) {
    const std::string tests = tests_of(r);
    key = key_of(r.method, r.change, r.precision, tests);
    add_once(methods_, r.method);
    add_once(precisions_, r.precision);
    add_once(tests_, tests);
  }
  const auto [entry, is_new] = index_.emplace(std::move(key), cells_.size());
  if (is_new) cells_.push_back({r, {}, 0, {}, {}, {}});
  return cells_[entry->second];
}

KernelResults::KernelResults(const std::vector<KernelRecord>& records) {
  for (const KernelRecord& r : records) {
    KernelCellResult& cell = cell_of(r);
    if (r.valid && !r.seconds.empty() && r.iterations > 0 && r.tests > 0) {
      cell.by_round[r.round] = nanoseconds_a_test(r);
      if (r.ticks) add_ticks(cell.ticks, r.round, *r.ticks);
    } else if (cell.void_rounds++ == 0) {
      cell.reason = r.reason;
    }
  }
  for (KernelCellResult& cell : cells_) {
    if (!cell.by_round.empty()) cell.nanoseconds = median_of(cell.by_round);
  }
}

const KernelCellResult* KernelResults::find(const std::string& method, const std::string& change,
                                            const std::string& precision, const std::string& tests) const {
  const auto found = index_.find(key_of(method, change, precision, tests));
  return found == index_.end() ? nullptr : &cells_[found->second];
}

std::optional<KernelRatio> KernelResults::against_base(const KernelCellResult& cell) const {
  const KernelRecord& r = cell.record;
  const KernelCellResult* const base = find(r.method, "base", r.precision, tests_of(r));
  if (!base || base == &cell) return {};
  std::map<int, double> ratios;
  for (const auto& [round, nanoseconds] : cell.by_round) {
    if (const auto of_base = base->by_round.find(round); of_base != base->by_round.end())
      ratios[round] = nanoseconds / of_base->second;
  }
  if (ratios.empty()) return {};
  return KernelRatio{median_of(ratios)};
}

KernelData read_kernel_run(const std::filesystem::path& folder) {
  const nlohmann::json plan = read_plan_file(folder);
  try {
    const auto cells = plan.at("cells").get<std::vector<std::string>>();
    std::vector<LeftOutVariant> left_out;
    for (const auto& one : plan.at("left_out"))
      left_out.push_back({one.at("method"), one.at("change"), one.at("precision"), one.at("reason")});
    return {plan.at("experiment"),
            plan.at("title"),
            plan.at("rounds"),
            cells.size(),
            std::move(left_out),
            KernelResults(in_order_of(cells, read_kernel_records(folder / "records.jsonl")))};
  } catch (const nlohmann::json::exception& error) {
    throw not_a_plan(folder, error.what());
  }
}

}  // namespace raysweep
