#include <fmt/format.h>

#include <algorithm>

#include "results/tables/accuracy_tables.h"

namespace raysweep {

namespace {

/// A cell beside that of the base variant on the same trials.
struct Pair {
  const AccuracyRecord *base, *changed;
};

/// Whether both have errors of one kind, and others.
bool errs_otherwise(const ErrorRecord& a, const ErrorRecord& b) {
  return a.count > 0 && b.count > 0 &&
         (a.p50 != b.p50 || a.p99 != b.p99 || a.p999 != b.p999 || a.max != b.max);
}

bool differs(const Pair& pair) {
  const AccuracyRecord &a = *pair.base, &b = *pair.changed;
  // What a variant was not asked for cannot be infinite.
  const bool same_output = a.variant.output == b.variant.output;
  return a.false_misses != b.false_misses || a.false_hits != b.false_hits || a.missed_rays != b.missed_rays ||
         a.extra != b.extra || (same_output && a.nonfinite != b.nonfinite) ||
         errs_otherwise(a.t_error, b.t_error) || errs_otherwise(a.uv_error, b.uv_error);
}

/// Those of all changed cells whose base was run, in the order of the records.
std::vector<Pair> pairs_of(const AccuracyResults& results) {
  std::vector<Pair> pairs;
  for (const AccuracyRecord& r : results.records()) {
    if (r.change == "base") continue;
    if (const auto* const base = results.find(r.method, "base", r.precision, r.case_id, r.level))
      pairs.push_back({base, &r});
  }
  return pairs;
}

std::string both(uint64_t before, uint64_t after) {
  return before == after ? fmt::format("{}", before) : fmt::format("{} → {}", before, after);
}

/// What one change of one method in one precision did over all cases.
struct Sum {
  const AccuracyRecord* first = nullptr;
  uint64_t cells = 0, differing = 0;
  uint64_t misses[2]{}, hits[2]{}, rays[2]{}, nonfinite[2]{};
  const AccuracyRecord* worst = nullptr;  // whose p99 of t grew most
  double factor = 0;

  void add(const Pair& pair) {
    if (!first) first = pair.changed;
    ++cells;
    differing += differs(pair);
    for (const size_t i : {size_t(0), size_t(1)}) {
      const AccuracyRecord& r = i == 0 ? *pair.base : *pair.changed;
      misses[i] += r.false_misses;
      hits[i] += r.false_hits;
      rays[i] += r.missed_rays;
      nonfinite[i] += r.nonfinite;
    }
    const ErrorRecord &before = pair.base->t_error, &after = pair.changed->t_error;
    if (before.count == 0 || after.count == 0 || before.p99 == 0 || after.p99 / before.p99 <= factor) return;
    factor = after.p99 / before.p99;
    worst = pair.changed;
  }

  [[nodiscard]] std::vector<std::string> row() const {
    const bool gives_t = worst != nullptr;
    return {first->method,
            first->change,
            first->precision,
            fmt::format("{}", cells),
            fmt::format("{}", differing),
            both(misses[0], misses[1]),
            both(hits[0], hits[1]),
            both(rays[0], rays[1]),
            gives_t ? both(nonfinite[0], nonfinite[1]) : "–",
            gives_t ? fmt::format("{:.3g} × at {}: {:g}", factor, worst->case_id, worst->difficulty) : "–"};
  }
};

}  // namespace

std::optional<Table> variant_table(const AccuracyResults& results) {
  std::vector<std::pair<std::string, Sum>> sums;
  std::map<std::string, size_t> places;
  for (const Pair& pair : pairs_of(results)) {
    const AccuracyRecord& r = *pair.changed;
    std::string key = r.method + '/' + r.change + '/' + r.precision;
    const auto place = places.emplace(key, sums.size()).first->second;
    if (place == sums.size()) sums.emplace_back(std::move(key), Sum());
    sums[place].second.add(pair);
  }
  if (sums.empty()) return {};
  Table table{
      "base variant → one factor changed: counts over all cells of both; t error: its 99th percentile "
      "where that grew most; changes that differ in no cell have no row",
      {{"method", false},
       {"change", false},
       {"precision", false},
       {"cells"},
       {"that differ"},
       {"false misses"},
       {"false hits"},
       {"missed rays"},
       {"not finite"},
       {"t error", false}},
      {}};
  for (const auto& [key, sum] : sums) {
    if (sum.differing > 0) table.rows.push_back(sum.row());
  }
  return table;
}

std::optional<Table> differing_cells_table(const AccuracyResults& results) {
  const std::vector<Pair> pairs = pairs_of(results);
  if (pairs.empty()) return {};
  Table table{"cells in which a variant differs from the base variant (base → variant)",
              {{"method", false},
               {"change", false},
               {"precision", false},
               {"case", false},
               {"difficulty"},
               {"false misses"},
               {"false hits"},
               {"missed rays"},
               {"extra hits"},
               {"t error p99"},
               {"uv error p99"}},
              {}};
  const auto errors = [](const ErrorRecord& a, const ErrorRecord& b) {
    return a.count > 0 && b.count > 0 ? fmt::format("{:.3g} → {:.3g}", a.p99, b.p99) : std::string("–");
  };
  for (const Pair& pair : pairs) {
    if (!differs(pair)) continue;
    const AccuracyRecord &a = *pair.base, &b = *pair.changed;
    table.rows.push_back({b.method, b.change, b.precision, b.case_id, fmt::format("{:g}", b.difficulty),
                          both(a.false_misses, b.false_misses), both(a.false_hits, b.false_hits),
                          both(a.missed_rays, b.missed_rays), both(a.extra, b.extra),
                          errors(a.t_error, b.t_error), errors(a.uv_error, b.uv_error)});
  }
  return table;
}

std::optional<Table> left_out_table(const std::vector<LeftOutVariant>& left_out) {
  if (left_out.empty()) return {};
  Table table{"variants that there are not",
              {{"method", false}, {"change", false}, {"precision", false}, {"reason", false}},
              {}};
  for (const LeftOutVariant& one : left_out)
    table.rows.push_back({one.method, one.change, one.precision, one.reason});
  return table;
}

}  // namespace raysweep
