#include "results/published.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <fstream>
#include <map>

#include "results/record.h"

namespace raysweep {

namespace {

std::vector<std::string> fields_of(const std::string& line) {
  std::vector<std::string> fields;
  for (size_t at = 0; at <= line.size();) {
    const size_t comma = std::min(line.find(',', at), line.size());
    fields.push_back(line.substr(at, comma - at));
    at = comma + 1;
  }
  return fields;
}

double number_of(const std::string& field) {
  double value = 0;
  const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), value);
  if (error != std::errc() || end != field.data() + field.size() || !(value > 0))
    throw RecordError(fmt::format("\"{}\" is no number above 0", field));
  return value;
}

/// The fields of a line under `columns` columns as numbers.
std::vector<double> numbers_of(const std::string& line, size_t columns) {
  const auto fields = fields_of(line);
  if (fields.size() != columns)
    throw RecordError(fmt::format("{} values under {} columns", fields.size(), columns));
  std::vector<double> numbers;
  for (const std::string& field : fields) numbers.push_back(number_of(field));
  return numbers;
}

struct FpsTable {
  std::vector<std::string> columns;
  std::map<double, std::vector<double>> rows;  // by threads, which are the first value
};

FpsTable read_table(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) throw RecordError(fmt::format("{}: cannot be opened", file.string()));
  FpsTable table;
  std::string line;
  for (int number = 1; std::getline(in, line); ++number) {
    try {
      if (number == 1) {
        table.columns = fields_of(line);
        if (table.columns.front() != "threads") throw RecordError("the first column must be \"threads\"");
        continue;
      }
      auto values = numbers_of(line, table.columns.size());
      table.rows[values.front()] = std::move(values);
    } catch (const RecordError& error) {
      throw RecordError(fmt::format("{}:{}: not a table of fps: {}", file.string(), number, error.what()));
    }
  }
  return table;
}

}  // namespace

std::vector<PublishedFps> published_fps(const std::filesystem::path& file) {
  const FpsTable table = read_table(file);
  std::vector<PublishedFps> modes;
  for (size_t i = 1; i < table.columns.size(); ++i) {
    PublishedFps& mode = modes.emplace_back(PublishedFps{table.columns[i], {}});
    for (const auto& [threads, values] : table.rows) mode.by_threads[static_cast<int>(threads)] = values[i];
  }
  return modes;
}

std::vector<PublishedYield> published_yields(const std::filesystem::path& file, int few_threads,
                                             int many_threads) {
  const FpsTable table = read_table(file);
  for (const int threads : {few_threads, many_threads}) {
    if (!table.rows.contains(threads))
      throw RecordError(fmt::format("{}: has no row for {} threads", file.string(), threads));
  }
  const auto& few = table.rows.at(few_threads);
  const auto& many = table.rows.at(many_threads);
  std::vector<PublishedYield> yields;
  for (size_t i = 1; i < table.columns.size(); ++i) yields.push_back({table.columns[i], many[i] / few[i]});
  return yields;
}

}  // namespace raysweep
