#include "results/tables/table_files.h"

#include "results/tables/write_file.h"

namespace raysweep {

void write_table(const std::filesystem::path& folder, const std::string& name, const Table& people,
                 const Table& programs) {
  write_file(folder / (name + ".md"), to_markdown(people));
  write_file(folder / (name + ".csv"), to_csv(programs));
  write_file(folder / (name + ".tex"), to_latex(people));
}

void write_table(const std::filesystem::path& folder, const std::string& name, const Table& table) {
  write_table(folder, name, table, table);
}

TableFolder::TableFolder(std::filesystem::path folder) : folder_(std::move(folder)) {
  std::filesystem::create_directories(folder_);
}

void TableFolder::write(const std::string& name, const Table& people, const Table& programs) {
  write_table(folder_, name, people, programs);
  tables_.push_back({name, people});
}

void remove_table(const std::filesystem::path& folder, const std::string& name) {
  for (const char* suffix : {".md", ".csv", ".tex"}) std::filesystem::remove(folder / (name + suffix));
}

}  // namespace raysweep
