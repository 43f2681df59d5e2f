// A table of text, and the ways to write it.
#pragma once

#include <string>
#include <vector>

namespace raysweep {

struct Table {
  struct Column {
    std::string title;
    bool right = true;  // numbers stand right, words left
  };
  std::string caption;
  std::vector<Column> columns;
  std::vector<std::vector<std::string>> rows;  // as many cells as there are columns
};

/// A table and the name of its files.
struct NamedTable {
  std::string name;
  Table table;
};

/// For a terminal: aligned columns, a rule under the head.
[[nodiscard]] std::string to_text(const Table& table);

/// GitHub-flavoured Markdown.
[[nodiscard]] std::string to_markdown(const Table& table);

/// A LaTeX `table`, with rules of the package booktabs.
[[nodiscard]] std::string to_latex(const Table& table);

/// RFC 4180, without the caption.
[[nodiscard]] std::string to_csv(const Table& table);

}  // namespace raysweep
