#include <fmt/format.h>

#include "results/tables/accuracy_tables.h"
#include "results/tables/contract_tables.h"
#include "results/tables/table_files.h"
#include "results/tables/write_file.h"

namespace raysweep {

std::string accuracy_tables_as_text(const AccuracyData& data, const Contract& contract) {
  std::string text = fmt::format("{}: {}; {} rays in each cell, {} cells\n", data.experiment, data.title,
                                 data.rays, data.results.records().size());
  const auto add = [&](const Table& table) { text.append("\n").append(to_text(table)); };
  for (const NamedTable& named : where_failing_tables(data.results)) add(named.table);
  for (const NamedTable& named : failure_tables(data.results)) add(named.table);
  if (const auto variants = variant_table(data.results)) add(*variants);
  add(contract_table(data.results, contract));
  if (const size_t count = contract_differences_table(data.results, contract).rows.size(); count > 0)
    text += fmt::format("\n{} numbers are not as promised: tables/contract-differences.md.\n", count);
  if (!data.left_out.empty())
    text += fmt::format("\n{} variants do not exist: tables/left-out.md says why of each.\n",
                        data.left_out.size());
  return text;
}

std::vector<NamedTable> write_accuracy_tables(const AccuracyData& data, const Contract& contract,
                                              const std::filesystem::path& folder) {
  TableFolder files(folder);
  const auto write = [&](const std::string& name, const Table& table) { files.write(name, table); };
  for (const auto tables : {where_failing_tables, failure_tables, case_tables}) {
    for (const NamedTable& named : tables(data.results)) write(named.name, named.table);
  }
  if (const auto table = variant_table(data.results)) write("variants", *table);
  if (const auto table = differing_cells_table(data.results)) write("variant-cells", *table);
  if (const auto table = left_out_table(data.left_out)) write("left-out", *table);
  write("contract", contract_table(data.results, contract));
  write("contract-differences", contract_differences_table(data.results, contract));
  write_file(folder / "cells.csv", to_csv(accuracy_data(data.results)));
  return files.tables();
}

}  // namespace raysweep
