#include "experiments/published_config.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include "results/record.h"

namespace raysweep {

namespace {

namespace fs = std::filesystem;

class PublishedParser {
 public:
  PublishedParser(TomlReader& reader, ClaimValues& values, const ClaimScope& scope)
      : reader_(reader), values_(values), scope_(scope) {}

  std::optional<PublishedTable> read(const toml::table& section) {
    reader_.check_keys(section, "published.",
                       {"file", "quantity", "rows", "row_values", "columns", "factors", "rename", "scale",
                        "normalise", "machine", "beside"});
    PublishedTable table;
    table.file = reader_.text_or(section, "file", "");
    read_quantity(section, table);
    table.scale = reader_.number_or(section, "scale", 1, 1e-15, 1e15);
    table.normalise = reader_.text_or(section, "normalise", "none");
    if (table.normalise != "none" && table.normalise != "first_row") {
      reader_.fail(section["normalise"],
                   fmt::format("unknown normalise \"{}\"; possible: first_row, none", table.normalise));
    }
    if (const auto* const machine = section.get("machine")) read_machine(*machine, table);
    PublishedLayout layout = layout_of(section);
    table.rows = layout.rows;
    if (table.file.empty() || layout.rows.empty()) {
      reader_.fail(section,
                   "[published] needs file and rows: file = \"published/NAME.csv\", rows = \"threads\"");
      return std::nullopt;
    }
    if (!add_numbers(section, table.file, layout, table)) return std::nullopt;
    const auto* const beside = section.get("beside");
    if (beside && !add_beside(*beside, layout, table)) return std::nullopt;
    return table;
  }

 private:
  /// False where something is wrong, which has been told.
  bool add_numbers(const toml::node& node, const std::string& file, const PublishedLayout& layout,
                   PublishedTable& table) {
    try {
      for (PrintedNumber& number : read_published(find(file), layout, table.quantity))
        table.numbers.push_back(std::move(number));
      return true;
    } catch (const RecordError& error) {
      reader_.fail(node, error.what());
      return false;
    }
  }

  /// Another table of the same layout, whose numbers differ in `factors`.
  bool add_beside(const toml::node& node, PublishedLayout& layout, PublishedTable& table) {
    const toml::table* const beside = node.as_table();
    const std::string file = beside ? reader_.text_or(*beside, "file", "") : "";
    if (file.empty() || !beside->contains("factors")) {
      reader_.fail(node,
                   "published.beside must be a table: { file = \"published/NAME.csv\", factors = { … } }");
      return false;
    }
    reader_.check_keys(*beside, "published.beside.", {"file", "factors"});
    layout.factors = own_factors(*beside->get("factors"));
    table.file += " and " + file;
    return add_numbers(node, file, layout, table);
  }

  void read_quantity(const toml::table& section, PublishedTable& table) {
    table.quantity = reader_.text_or(section, "quantity", scope_.quantities.front());
    if (std::ranges::find(scope_.quantities, table.quantity) == scope_.quantities.end()) {
      reader_.fail(section["quantity"], fmt::format("unknown quantity \"{}\"; possible: {}", table.quantity,
                                                    fmt::join(scope_.quantities, ", ")));
    }
  }

  void read_machine(const toml::node& node, PublishedTable& table) {
    if (!node.is_table()) {
      reader_.fail(node, "published.machine must be a table: { cores = 6, pus = 12 }");
      return;
    }
    const toml::table& machine = *node.as_table();
    reader_.check_keys(machine, "published.machine.", {"cores", "pus"});
    table.machine.cores = reader_.integer_or(machine, "cores", 0, 1, 1 << 20);
    table.machine.pus = reader_.integer_or(machine, "pus", table.machine.cores, 1, 1 << 20);
  }

  PublishedLayout layout_of(const toml::table& section) {
    PublishedLayout layout;
    if (const auto* const rows = section.get("rows")) layout.rows = values_.texts(*rows, "published.rows");
    if (const auto* const columns = section.get("columns"))
      layout.columns = values_.texts(*columns, "published.columns");
    layout.row_values = reader_.text_or(section, "row_values", "{}");
    if (layout.row_values.find("{}") == std::string::npos)
      reader_.fail(section["row_values"],
                   "published.row_values must hold {}, which stands for what is printed");
    if (const auto* const factors = section.get("factors")) layout.factors = own_factors(*factors);
    const toml::node* const rename = section.get("rename");
    if (rename && !rename->is_table()) {
      reader_.fail(*rename, "published.rename must be a table: { HEAD = { threads = 4 } }");
    } else if (rename) {
      for (const auto& [head, node] : *rename->as_table())
        layout.rename[std::string(head.str())] = own_factors(node);
    }
    return layout;
  }

  /// Printed values need not be among ours.
  Factors own_factors(const toml::node& node) {
    Factors made;
    if (!node.is_table()) {
      reader_.fail(node, "published.factors and what published.rename names must be tables: { threads = 4 }");
      return made;
    }
    for (const auto& [key, value] : *node.as_table()) {
      if (const auto one = values_.text(value, fmt::format("published.{}", key.str())))
        made[std::string(key.str())] = *one;
    }
    return made;
  }

  /// As it is where there is none, for the error to name.
  [[nodiscard]] fs::path find(const std::string& file) const {
    fs::path of_sources = fs::path(RAYSWEEP_RESULTS_DIR) / file;
    if (fs::exists(of_sources)) return of_sources;
    fs::path beside = fs::path(reader_.file()).parent_path() / file;
    if (fs::exists(beside)) return beside;
    return file;
  }

  TomlReader& reader_;
  ClaimValues& values_;
  const ClaimScope& scope_;
};

}  // namespace

std::optional<PublishedTable> read_published_table(TomlReader& reader, ClaimValues& values,
                                                   const toml::table& root, const ClaimScope& scope) {
  const toml::table* const section = reader.section(root, "published");
  if (!section) return std::nullopt;
  return PublishedParser(reader, values, scope).read(*section);
}

}  // namespace raysweep
