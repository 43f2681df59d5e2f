#include <fmt/format.h>

#include <cmath>

#include "results/tables/kernel_tables.h"
#include "results/tables/number_text.h"
#include "results/tables/small_kernel_tables.h"
#include "results/tables/table_files.h"
#include "results/tables/write_file.h"

namespace raysweep {

namespace {

std::vector<std::string> data_row(const KernelResults& results, const KernelCellResult& cell) {
  const KernelRecord& r = cell.record;
  const VariantRecord& v = r.variant;
  const auto whole = [](auto number) { return fmt::format("{}", number); };
  std::vector<std::string> row{r.cell,
                               r.method,
                               r.change,
                               r.precision,
                               v.division,
                               v.reciprocal,
                               v.order,
                               v.edges,
                               v.early_out,
                               v.output,
                               v.data,
                               whole(r.rays_at_once),
                               whole(r.triangles_at_once),
                               r.layout,
                               r.contraction,
                               r.compiler,
                               r.isa,
                               whole(r.bytes),
                               r.protocol,
                               std::isnan(r.parameter) ? "" : whole(r.parameter),
                               r.scene,
                               whole(r.threads),
                               whole(r.hit_rate),
                               whole(r.tests),
                               whole(cell.by_round.size()),
                               whole(cell.void_rounds)};
  const auto ratio = results.against_base(cell);
  for (const auto& text : unrounded(cell.nanoseconds)) row.push_back(text);
  for (const auto& text : unrounded(ratio ? std::optional(ratio->estimate) : std::nullopt))
    row.push_back(text);
  return row;
}

}  // namespace

Table kernel_data(const KernelResults& results) {
  if (!results.are_intersection()) return small_kernel_data(results);
  Table table;
  for (const char* title : {"cell",
                            "method",
                            "change",
                            "precision",
                            "division",
                            "reciprocal",
                            "order",
                            "edges",
                            "early_out",
                            "output",
                            "data",
                            "rays_at_once",
                            "triangles_at_once",
                            "layout",
                            "contraction",
                            "compiler",
                            "isa",
                            "bytes",
                            "protocol",
                            "parameter",
                            "scene",
                            "threads",
                            "hit_rate",
                            "tests",
                            "rounds",
                            "void_rounds",
                            "ns_a_test",
                            "ns_low",
                            "ns_high",
                            "ratio_to_base",
                            "ratio_low",
                            "ratio_high"})
    table.columns.push_back({title});
  for (const KernelCellResult& cell : results.cells()) table.rows.push_back(data_row(results, cell));
  return table;
}

std::string kernel_tables_as_text(const KernelData& data) {
  std::string text = fmt::format("{}: {}; {} of {} cells, {} rounds asked for\n", data.experiment, data.title,
                                 data.results.cells().size(), data.cells, data.rounds);
  const auto add = [&](const Table& table) { text.append("\n").append(to_text(table)); };
  for (const auto tables : {speed_tables, hit_rate_tables, operation_tables, tick_tables}) {
    for (const NamedTable& named : tables(data.results)) add(named.table);
  }
  if (const auto table = void_table(data.results)) add(*table);
  for (const NamedTable& named : factor_tables(data.results))
    text += fmt::format("\nWhat each factor changes, {} rows: tables/{}.md.\n", named.table.rows.size(),
                        named.name);
  if (!data.left_out.empty())
    text += fmt::format("\n{} variants do not exist: tables/left-out.md says why of each.\n",
                        data.left_out.size());
  return text;
}

std::vector<NamedTable> write_kernel_tables(const KernelData& data, const std::filesystem::path& folder) {
  TableFolder files(folder);
  const auto write = [&](const std::string& name, const Table& table) { files.write(name, table); };
  for (const auto tables : {speed_tables, hit_rate_tables, factor_tables, operation_tables, tick_tables}) {
    for (const NamedTable& named : tables(data.results)) write(named.name, named.table);
  }
  if (const auto table = void_table(data.results)) write("void", *table);
  if (const auto table = left_out_table(data.left_out)) write("left-out", *table);
  write_file(folder / "cells.csv", to_csv(kernel_data(data.results)));
  return files.tables();
}

}  // namespace raysweep
