// A table as files.
#pragma once

#include <filesystem>
#include <string>

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

}  // namespace raysweep
