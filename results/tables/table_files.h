// A table as files.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "results/tables/table.h"

namespace raysweep {

/// Writes NAME.md and NAME.tex with what `people` read, and NAME.csv with what `programs` do, into `folder`.
/// Throws std::runtime_error where one cannot be written whole.
void write_table(const std::filesystem::path& folder, const std::string& name, const Table& people,
                 const Table& programs);

/// The same table for both.
void write_table(const std::filesystem::path& folder, const std::string& name, const Table& table);

/// What `write_table` wrote of that name, gone.
void remove_table(const std::filesystem::path& folder, const std::string& name);

/// A folder that a run's tables are written into, one after the other, and what people read of them.
class TableFolder {
 public:
  /// Makes it. Throws as std::filesystem.
  explicit TableFolder(std::filesystem::path folder);

  /// As `write_table`.
  void write(const std::string& name, const Table& people, const Table& programs);
  void write(const std::string& name, const Table& table) { write(name, table, table); }
  [[nodiscard]] const std::vector<NamedTable>& tables() const { return tables_; }

 private:
  std::filesystem::path folder_;
  std::vector<NamedTable> tables_;
};

}  // namespace raysweep
