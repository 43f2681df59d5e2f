#include "results/tables/kernel_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "results/tables/number_text.h"

namespace raysweep {

namespace {

/// Tests of base kernels in one precision.
std::vector<std::string> tests_of_base(const KernelResults& results, const std::string& precision) {
  std::vector<std::string> list;
  for (const std::string& tests : results.tests()) {
    const bool any = std::ranges::any_of(results.methods(), [&](const std::string& method) {
      return results.find(method, "base", precision, tests) != nullptr;
    });
    if (any) list.push_back(tests);
  }
  return list;
}

/// What lists of tests share that differ by their hit rate, which is told between 0 and 1.
std::string family_of(const KernelRecord& r) {
  return fmt::format("{}/{}/{}", r.protocol, r.scheduler, r.threads);
}

/// Families with three lists of tests or more: they are a curve.
std::set<std::string> curves_of(const KernelResults& results) {
  std::map<std::string, std::set<double>> parameters;
  for (const KernelCellResult& cell : results.cells()) {
    const KernelRecord& r = cell.record;
    if (r.protocol == "hit-rate") parameters[family_of(r)].insert(r.parameter);
  }
  std::set<std::string> curves;
  for (const auto& [family, values] : parameters) {
    if (values.size() >= 3) curves.insert(family);
  }
  return curves;
}

bool is_on_curve(const KernelResults& results, const std::set<std::string>& curves,
                 const std::string& tests) {
  return std::ranges::any_of(results.cells(), [&](const KernelCellResult& cell) {
    return tests_of(cell.record) == tests && curves.contains(family_of(cell.record));
  });
}

std::optional<double> best_of(const KernelResults& results, const std::string& precision,
                              const std::string& tests) {
  std::optional<double> best;
  for (const std::string& method : results.methods()) {
    const auto* const cell = results.find(method, "base", precision, tests);
    if (cell && cell->nanoseconds && !(best && *best <= cell->nanoseconds->value))
      best = cell->nanoseconds->value;
  }
  return best;
}

/// Of the first base kernel of a method in this precision; the same on all tests.
std::string bytes_of(const KernelResults& results, const std::string& method, const std::string& precision) {
  for (const std::string& tests : results.tests()) {
    if (const auto* const cell = results.find(method, "base", precision, tests))
      return fmt::format("{}", cell->record.bytes);
  }
  return "–";
}

/// Methods × `columns`; nothing without columns.
std::optional<Table> method_table(const KernelResults& results, const std::string& precision,
                                  const std::string& caption, const std::vector<std::string>& columns,
                                  bool with_best) {
  if (columns.empty()) return {};
  Table table{caption, {{"method", false}, {"bytes a triangle"}}, {}};
  for (const std::string& tests : columns) {
    table.columns.push_back({tests});
    if (with_best) table.columns.push_back({"× best"});
  }
  for (const std::string& method : results.methods()) {
    std::vector<std::string> row{method, bytes_of(results, method, precision)};
    for (const std::string& tests : columns) {
      const auto* const cell = results.find(method, "base", precision, tests);
      const auto nanoseconds = cell ? cell->nanoseconds : std::nullopt;
      row.push_back(with_interval(nanoseconds));
      const auto best = best_of(results, precision, tests);
      if (with_best) row.push_back(nanoseconds && best ? significant(nanoseconds->value / *best) : "–");
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

/// "0.913 [0.900, 0.921]"
std::string ratio_text(const KernelResults& results, const KernelCellResult* cell) {
  if (!cell) return "–";
  const auto ratio = results.against_base(*cell);
  if (!ratio) return "–";
  const std::string number = with_interval(ratio->estimate);
  if (!ratio->estimate.interval) return number + ", no interval";
  return ratio->shows_difference() ? number : "no difference shown: " + number;
}

/// Changes in the order of the records, of all methods.
std::vector<std::string> changes_of(const KernelResults& results, const std::string& method,
                                    const std::string& precision) {
  std::vector<std::string> changes;
  for (const KernelCellResult& cell : results.cells()) {
    const KernelRecord& r = cell.record;
    if (r.method == method && r.precision == precision && r.change != "base" &&
        std::ranges::find(changes, r.change) == changes.end())
      changes.push_back(r.change);
  }
  return changes;
}

}  // namespace

std::vector<NamedTable> speed_tables(const KernelResults& results) {
  std::vector<NamedTable> tables;
  const std::set<std::string> curves = curves_of(results);
  for (const std::string& precision : results.precisions()) {
    std::vector<std::string> columns = tests_of_base(results, precision);
    std::erase_if(columns, [&](const std::string& tests) { return is_on_curve(results, curves, tests); });
    auto table = method_table(results, precision,
                              fmt::format("{}: nanoseconds a test of base kernels, median over rounds with "
                                          "its 95 % interval, and × the best method's",
                                          precision),
                              columns, true);
    if (table) tables.push_back({"speed-" + precision, std::move(*table)});
  }
  return tables;
}

std::vector<NamedTable> hit_rate_tables(const KernelResults& results) {
  std::vector<NamedTable> tables;
  const std::set<std::string> curves = curves_of(results);
  for (const std::string& precision : results.precisions()) {
    std::vector<std::string> columns = tests_of_base(results, precision);
    std::erase_if(columns, [&](const std::string& tests) { return !is_on_curve(results, curves, tests); });
    auto table = method_table(
        results, precision,
        fmt::format("{}: nanoseconds a test of base kernels by the share of tests that are hits", precision),
        columns, false);
    if (table) tables.push_back({"hit-rates-" + precision, std::move(*table)});
  }
  return tables;
}

std::vector<NamedTable> factor_tables(const KernelResults& results) {
  std::vector<NamedTable> tables;
  for (const std::string& precision : results.precisions()) {
    Table table{
        fmt::format("{}: time of a kernel with one factor changed, × the base kernel's of its method; "
                    "median over rounds with its 95 % interval, which is of this ratio alone",
                    precision),
        {{"method", false}, {"change", false}},
        {}};
    for (const std::string& tests : results.tests()) table.columns.push_back({tests});
    for (const std::string& method : results.methods()) {
      for (const std::string& change : changes_of(results, method, precision)) {
        std::vector<std::string> row{method, change};
        for (const std::string& tests : results.tests())
          row.push_back(ratio_text(results, results.find(method, change, precision, tests)));
        table.rows.push_back(std::move(row));
      }
    }
    if (!table.rows.empty()) tables.push_back({"factors-" + precision, std::move(table)});
  }
  return tables;
}

std::optional<Table> void_table(const KernelResults& results) {
  Table table{"cells whose results were wrong, which were not timed",
              {{"cell", false}, {"rounds"}, {"reason", false}},
              {}};
  for (const KernelCellResult& cell : results.cells()) {
    if (cell.void_rounds > 0)
      table.rows.push_back({cell.record.cell, fmt::format("{}", cell.void_rounds), cell.reason});
  }
  if (table.rows.empty()) return {};
  return table;
}

}  // namespace raysweep
