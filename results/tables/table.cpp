#include "results/tables/table.h"

#include <fmt/format.h>

#include <algorithm>

namespace raysweep {

namespace {

/// Columns on a terminal: UTF-8 continuation bytes take no room.
size_t display_width(const std::string& text) {
  return static_cast<size_t>(
      std::ranges::count_if(text, [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

std::string pad(const std::string& text, size_t width, bool right) {
  const std::string space(width - std::min(width, display_width(text)), ' ');
  return right ? space + text : text + space;
}

std::vector<size_t> column_widths(const Table& table) {
  std::vector<size_t> widths;
  for (size_t i = 0; i < table.columns.size(); ++i) {
    size_t width = display_width(table.columns[i].title);
    for (const auto& row : table.rows) width = std::max(width, display_width(row[i]));
    widths.push_back(width);
  }
  return widths;
}

std::string join_line(const Table& table, const std::vector<std::string>& cells,
                      const std::vector<size_t>& widths, const char* before, const char* between,
                      const char* after) {
  std::string line = before;
  for (size_t i = 0; i < cells.size(); ++i) {
    if (i > 0) line += between;
    line += pad(cells[i], widths[i], table.columns[i].right);
  }
  line += after;
  return line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
}

std::vector<std::string> titles(const Table& table) {
  std::vector<std::string> list;
  for (const auto& column : table.columns) list.push_back(column.title);
  return list;
}

std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + "\"";
}

}  // namespace

std::string to_text(const Table& table) {
  const auto widths = column_widths(table);
  std::string text = table.caption.empty() ? "" : table.caption + "\n";
  const std::string head = join_line(table, titles(table), widths, "", "  ", "");
  text += head;
  for (size_t i = 0; i < widths.size(); ++i) {
    for (size_t k = 0; k < widths[i]; ++k) text += "─";
    text += i + 1 < widths.size() ? "  " : "\n";
  }
  for (const auto& row : table.rows) text += join_line(table, row, widths, "", "  ", "");
  return text;
}

std::string to_markdown(const Table& table) {
  const auto widths = column_widths(table);
  std::string text = table.caption.empty() ? "" : table.caption + "\n\n";
  text += join_line(table, titles(table), widths, "| ", " | ", " |");
  text += "|";
  for (size_t i = 0; i < widths.size(); ++i) {
    text += std::string(widths[i] + 1, '-') + (table.columns[i].right ? ":|" : "-|");
  }
  text += "\n";
  for (const auto& row : table.rows) text += join_line(table, row, widths, "| ", " | ", " |");
  return text;
}

std::string to_csv(const Table& table) {
  const auto line = [](const std::vector<std::string>& cells) {
    std::string text;
    for (size_t i = 0; i < cells.size(); ++i) text.append(i > 0 ? "," : "").append(csv_field(cells[i]));
    return text + "\n";
  };
  std::string text = line(titles(table));
  for (const auto& row : table.rows) text += line(row);
  return text;
}

}  // namespace raysweep
