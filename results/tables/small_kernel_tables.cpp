#include "results/tables/small_kernel_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "results/tables/number_text.h"

namespace raysweep {

namespace {

using Cells = std::vector<const KernelCellResult*>;
using Texts = std::vector<std::string>;

void add_once(Texts& list, const std::string& text) {
  if (std::ranges::find(list, text) == list.end()) list.push_back(text);
}

/// In the order of the records.
std::vector<std::pair<std::string, Cells>> by_kernel(const KernelResults& results) {
  std::vector<std::pair<std::string, Cells>> list;
  if (results.are_intersection()) return list;
  for (const KernelCellResult& cell : results.cells()) {
    const auto found = std::ranges::find(list, cell.record.kernel, &std::pair<std::string, Cells>::first);
    if (found == list.end())
      list.push_back({cell.record.kernel, {&cell}});
    else
      found->second.push_back(&cell);
  }
  return list;
}

Texts factors_of(const Cells& cells) {
  Texts names;
  for (const KernelCellResult* cell : cells) {
    for (const auto& [name, value] : cell->record.factors) add_once(names, name);
  }
  return names;
}

std::string value_of(const KernelCellResult& cell, const std::string& factor) {
  const auto found = cell.record.factors.find(factor);
  return found == cell.record.factors.end() ? "" : found->second;
}

Texts values_of(const Cells& cells, const std::string& factor) {
  Texts values;
  for (const KernelCellResult* cell : cells) add_once(values, value_of(*cell, factor));
  return values;
}

bool is_number(const std::string& text) {
  double number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc() && end == text.data() + text.size();
}

/// The factor with most values that are names.
std::string compared_factor(const Cells& cells) {
  std::string best;
  size_t most = 0;
  for (const std::string& factor : factors_of(cells)) {
    const Texts values = values_of(cells, factor);
    if (std::ranges::any_of(values, is_number) || values.size() <= most) continue;
    best = factor;
    most = values.size();
  }
  return best;
}

std::optional<double> quickest_of(const Cells& row) {
  std::optional<double> best;
  for (const KernelCellResult* cell : row) {
    if (cell && cell->nanoseconds && !(best && *best <= cell->nanoseconds->value))
      best = cell->nanoseconds->value;
  }
  return best;
}

Table operation_table(const std::string& kernel, const Cells& cells) {
  const std::string compared = compared_factor(cells);
  const Texts columns = values_of(cells, compared);
  Texts factors = factors_of(cells);
  std::erase(factors, compared);
  std::vector<std::pair<Texts, Cells>> rows;  // other factors' values, and cells as in `columns`
  for (const KernelCellResult* cell : cells) {
    Texts key;
    for (const std::string& factor : factors) key.push_back(value_of(*cell, factor));
    auto row = std::ranges::find(rows, key, &std::pair<Texts, Cells>::first);
    if (row == rows.end()) row = rows.insert(rows.end(), {key, Cells(columns.size())});
    row->second[static_cast<size_t>(std::ranges::find(columns, value_of(*cell, compared)) -
                                    columns.begin())] = cell;
  }
  Table table{
      fmt::format("{}: nanoseconds an operation, median over rounds with its 95 % interval, and × the "
                  "quickest of the row",
                  kernel),
      {},
      {}};
  for (const std::string& factor : factors) table.columns.push_back({factor});
  for (const std::string& column : columns) {
    table.columns.push_back({column});
    table.columns.push_back({"× best"});
  }
  for (const auto& [key, of_row] : rows) {
    table.rows.push_back(key);
    const auto best = quickest_of(of_row);
    for (const KernelCellResult* cell : of_row) {
      const auto nanoseconds = cell ? cell->nanoseconds : std::nullopt;
      table.rows.back().push_back(with_interval(nanoseconds));
      table.rows.back().push_back(nanoseconds && best ? significant(nanoseconds->value / *best) : "–");
    }
  }
  return table;
}

}  // namespace

std::vector<NamedTable> operation_tables(const KernelResults& results) {
  std::vector<NamedTable> tables;
  for (const auto& [kernel, cells] : by_kernel(results))
    tables.push_back({kernel, operation_table(kernel, cells)});
  return tables;
}

std::vector<NamedTable> tick_tables(const KernelResults& results) {
  std::vector<NamedTable> tables;
  for (const auto& [kernel, cells] : by_kernel(results)) {
    const Texts factors = factors_of(cells);
    Table table{fmt::format("{}: ticks of operations timed one by one, medians over rounds with their 95 % "
                            "intervals",
                            kernel),
                {},
                {}};
    for (const std::string& factor : factors)
      table.columns.push_back({factor, std::ranges::all_of(values_of(cells, factor), is_number)});
    for (const std::string& statistic : tick_statistics()) table.columns.push_back({statistic});
    for (const KernelCellResult* cell : cells) {
      if (cell->ticks.empty()) continue;
      table.rows.emplace_back();
      for (const std::string& factor : factors) table.rows.back().push_back(value_of(*cell, factor));
      for (const std::string& statistic : tick_statistics())
        table.rows.back().push_back(with_interval(median_of(cell->ticks.at(statistic))));
    }
    if (!table.rows.empty()) tables.push_back({kernel + "-ticks", std::move(table)});
  }
  return tables;
}

Table small_kernel_data(const KernelResults& results) {
  Cells all;
  for (const KernelCellResult& cell : results.cells()) all.push_back(&cell);
  const Texts factors = factors_of(all);
  Table table{"", {{"cell"}, {"kernel"}}, {}};
  for (const std::string& factor : factors) table.columns.push_back({factor});
  for (const char* title : {"compiler", "operations", "rounds", "void_rounds", "ns_an_operation", "ns_low",
                            "ns_high", "ticks_min", "ticks_avg", "ticks_max", "ticks_sum"})
    table.columns.push_back({title});
  for (const KernelCellResult* cell : all) {
    const KernelRecord& r = cell->record;
    Texts row{r.cell, r.kernel};
    for (const std::string& factor : factors) row.push_back(value_of(*cell, factor));
    row.push_back(r.compiler);
    for (const size_t count : {size_t{r.tests}, cell->by_round.size(), size_t(cell->void_rounds)})
      row.push_back(fmt::format("{}", count));
    for (const auto& text : unrounded(cell->nanoseconds)) row.push_back(text);
    for (const std::string& statistic : tick_statistics()) {
      const auto found = cell->ticks.find(statistic);
      row.push_back(found == cell->ticks.end() ? "" : unrounded(median_of(found->second))[0]);
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

}  // namespace raysweep
