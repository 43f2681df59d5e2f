#include "results/tables/accuracy_tables.h"

#include <fmt/format.h>

#include <algorithm>

#include "results/statistics/statistics.h"

namespace raysweep {

namespace {

using CountOf = Failures (*)(const AccuracyRecord&);

/// A base variant's record of any method: what is common to all methods, such as the oracle's hits.
const AccuracyRecord* any_record(const AccuracyResults& results, const std::string& precision,
                                 const std::string& id, int level) {
  for (const std::string& method : results.methods()) {
    if (const auto* record = results.find(method, "base", precision, id, level)) return record;
  }
  return nullptr;
}

struct Column {
  std::string id;
  int level;
};

/// Cases with something to fail, each at its hardest such level.
std::vector<Column> hardest(const AccuracyResults& results, const std::string& precision, CountOf count_of,
                            Table& table) {
  std::vector<Column> columns;
  for (const std::string& id : results.cases()) {
    const std::vector<int> levels = results.levels(id);
    for (auto level = levels.rbegin(); level != levels.rend(); ++level) {
      const AccuracyRecord* const record = any_record(results, precision, id, *level);
      if (!record || count_of(*record).of == 0) continue;
      columns.push_back({id, *level});
      table.columns.push_back({fmt::format("{}: {:g}", id, record->difficulty)});
      break;
    }
  }
  return columns;
}

struct Kind {
  std::string_view name, caption;
  CountOf count_of;
};

constexpr Kind kinds[] = {
    {"false-misses", "false misses per million hits of the oracle", false_misses},
    {"false-hits", "false hits per million misses of the oracle", false_hits},
    {"missed-rays", "rays per million that pass a mesh though by the oracle they do not", missed_rays}};

std::optional<Table> failure_table(const AccuracyResults& results, const std::string& precision,
                                   const Kind& kind) {
  Table table{fmt::format("{}, {}; case: its hardest difficulty with any; ≤: none seen, 95 %", kind.caption,
                          precision),
              {{"method", false}},
              {}};
  const std::vector<Column> columns = hardest(results, precision, kind.count_of, table);
  if (columns.empty()) return {};
  for (const std::string& method : results.methods()) {
    std::vector<std::string> row{method};
    for (const Column& column : columns) {
      const auto* const record = results.find(method, "base", precision, column.id, column.level);
      row.push_back(record ? per_million(kind.count_of(*record)) : "–");
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

/// "1e-06", "never", or "–" where nothing was run.
std::string first_failure(const AccuracyResults& results, const std::string& method,
                          const std::string& precision, const std::string& id) {
  const char* otherwise = "–";
  for (const int level : results.levels(id)) {
    const auto* const record = results.find(method, "base", precision, id, level);
    if (!record) continue;
    if (has_failed(*record)) return fmt::format("{:g}", record->difficulty);
    otherwise = "never";
  }
  return otherwise;
}

}  // namespace

std::string per_million(const Failures& f) {
  if (f.of == 0) return "–";
  const double share = f.count > 0 ? static_cast<double>(f.count) / static_cast<double>(f.of)
                                   : std::min(zero_failures_bound(f.of), 1.0);
  const double rate = share * 1e6;
  return fmt::format("{}{:.{}f}", f.count > 0 ? "" : "≤ ", rate, rate >= 100 ? 0 : rate >= 10 ? 1 : 2);
}

std::vector<NamedTable> failure_tables(const AccuracyResults& results) {
  std::vector<NamedTable> tables;
  for (const Kind& kind : kinds) {
    for (const std::string& precision : results.precisions()) {
      if (auto table = failure_table(results, precision, kind))
        tables.push_back({fmt::format("{}-{}", kind.name, precision), std::move(*table)});
    }
  }
  return tables;
}

std::vector<NamedTable> where_failing_tables(const AccuracyResults& results) {
  std::vector<NamedTable> tables;
  for (const std::string& precision : results.precisions()) {
    Table table{
        fmt::format("first difficulty with a false miss, a false hit, a missed ray or a number that is "
                    "not finite, {}",
                    precision),
        {{"method", false}},
        {}};
    for (const std::string& id : results.cases()) table.columns.push_back({id});
    for (const std::string& method : results.methods()) {
      std::vector<std::string> row{method};
      for (const std::string& id : results.cases())
        row.push_back(first_failure(results, method, precision, id));
      table.rows.push_back(std::move(row));
    }
    tables.push_back({"where-failing-" + precision, std::move(table)});
  }
  return tables;
}

}  // namespace raysweep
