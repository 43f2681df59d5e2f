#include <fmt/format.h>

#include <cmath>

#include "results/tables/accuracy_tables.h"

namespace raysweep {

namespace {

/// "0.52", "3.1e+04"; "–" without errors.
std::string error_text(const ErrorRecord& error) {
  return error.count > 0 ? fmt::format("{:.3g}", error.p99) : "–";
}

Table head_of(const AccuracyResults& results, const std::string& id, const std::string& difficulty) {
  Table table{
      fmt::format("{}: failures per million, and the 99th percentile of the relative error of t in ε; "
                  "difficulty: {}",
                  id, difficulty),
      {{"difficulty"}, {"method", false}},
      {}};
  for (const std::string& precision : results.precisions()) {
    for (const char* what : {"false misses", "false hits", "missed rays", "t error p99"})
      table.columns.push_back({fmt::format("{}, {}", what, precision)});
  }
  return table;
}

void add_row(Table& table, const AccuracyResults& results, const std::string& id, int level,
             const std::string& method) {
  std::vector<std::string> row{"", method};
  for (const std::string& precision : results.precisions()) {
    const auto* const r = results.find(method, "base", precision, id, level);
    if (r) row.front() = fmt::format("{:g}", r->difficulty);
    for (const auto count_of : {false_misses, false_hits, missed_rays})
      row.push_back(r ? per_million(count_of(*r)) : "–");
    row.push_back(r ? error_text(r->t_error) : "–");
  }
  if (!row.front().empty()) table.rows.push_back(std::move(row));
}

/// Every digit; empty for none.
std::string digits(double value) { return std::isnan(value) ? "" : fmt::format("{}", value); }

void add_error(std::vector<std::string>& row, const ErrorRecord& e) {
  row.push_back(std::to_string(e.count));
  for (const double value : {e.p50, e.p99, e.p999, e.max, e.mean}) row.push_back(digits(value));
}

std::vector<std::string> data_row(const AccuracyRecord& r) {
  const VariantRecord& v = r.variant;
  std::vector<std::string> row{r.method, r.change,    v.division,  v.reciprocal,
                               v.order,  v.edges,     v.early_out, v.output,
                               v.data,   r.precision, r.case_id,   fmt::format("{}", r.difficulty)};
  for (const uint64_t count :
       {r.rays, r.mesh_rays, r.trials, r.hits, r.boundary, r.false_hits, r.false_misses, r.nonfinite,
        r.missed_rays, r.extra, r.uncovered, r.other_nearest})
    row.push_back(std::to_string(count));
  for (const ErrorRecord* error : {&r.t_error, &r.uv_error, &r.weight_error, &r.consistency, &r.off_plane})
    add_error(row, *error);
  return row;
}

}  // namespace

std::vector<NamedTable> case_tables(const AccuracyResults& results) {
  std::map<std::string, std::string> difficulties;
  for (const AccuracyRecord& record : results.records())
    difficulties.emplace(record.case_id, record.difficulty_of);
  std::vector<NamedTable> tables;
  for (const std::string& id : results.cases()) {
    Table table = head_of(results, id, difficulties[id]);
    for (const int level : results.levels(id)) {
      for (const std::string& method : results.methods()) add_row(table, results, id, level, method);
    }
    tables.push_back({"case-" + id, std::move(table)});
  }
  return tables;
}

Table accuracy_data(const AccuracyResults& results) {
  Table table;
  for (const char* name :
       {"method",       "change",    "division",    "reciprocal", "order",     "edges",
        "early_out",    "output",    "data",        "precision",  "case",      "difficulty",
        "rays",         "mesh_rays", "trials",      "hits",       "boundary",  "false_hits",
        "false_misses", "nonfinite", "missed_rays", "extra",      "uncovered", "other_nearest"})
    table.columns.push_back({name});
  for (const char* error : {"t_error", "uv_error", "weight_error", "consistency", "off_plane"}) {
    for (const char* part : {"count", "p50", "p99", "p999", "max", "mean"})
      table.columns.push_back({fmt::format("{}_{}", error, part)});
  }
  for (const AccuracyRecord& record : results.records()) table.rows.push_back(data_row(record));
  return table;
}

}  // namespace raysweep
