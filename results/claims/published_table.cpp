#include "results/claims/published_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <set>

#include "results/record.h"

namespace raysweep {

namespace {

std::vector<std::string> split(const std::string& text, char separator, size_t most) {
  std::vector<std::string> parts;
  size_t at = 0;
  while (parts.size() + 1 < most && text.find(separator, at) != std::string::npos) {
    const size_t end = text.find(separator, at);
    parts.push_back(text.substr(at, end - at));
    at = end + 1;
  }
  parts.push_back(text.substr(at));
  return parts;
}

/// What the numbers under a head are of.
Factors factors_of_head(const std::string& head, const PublishedLayout& layout, const std::string& quantity) {
  if (const auto found = layout.rename.find(head); found != layout.rename.end()) return found->second;
  if (layout.columns.empty() && head == quantity) return {};
  if (layout.columns.empty())
    throw RecordError(fmt::format("column \"{}\" has no name: give `columns` or `rename`", head));
  const auto values = split(head, '_', layout.columns.size());
  if (values.size() != layout.columns.size()) {
    throw RecordError(fmt::format("column \"{}\" has not one value for each of {}; `rename` says what it is",
                                  head, fmt::join(layout.columns, ", ")));
  }
  Factors factors;
  for (size_t i = 0; i < values.size(); ++i) factors[layout.columns[i]] = values[i];
  return factors;
}

std::string in_place_of_braces(const std::string& pattern, const std::string& value) {
  const size_t at = pattern.find("{}");
  return at == std::string::npos ? value : pattern.substr(0, at) + value + pattern.substr(at + 2);
}

class Reader {
 public:
  Reader(const PublishedLayout& layout, const std::string& quantity) : layout_(layout), quantity_(quantity) {}

  void read_head(const std::string& line) {
    heads_ = split(line, ',', line.size() + 1);
    if (heads_.size() <= layout_.rows.size())
      throw RecordError(
          fmt::format("{} columns, where the first {} are factors", heads_.size(), layout_.rows.size()));
    for (size_t i = layout_.rows.size(); i < heads_.size(); ++i)
      columns_.push_back(factors_of_head(heads_[i], layout_, quantity_));
  }

  void read_line(const std::string& line) {
    const auto fields = split(line, ',', line.size() + 1);
    if (fields.size() != heads_.size())
      throw RecordError(fmt::format("{} values under {} columns", fields.size(), heads_.size()));
    Factors of_line = layout_.factors;
    for (size_t i = 0; i < layout_.rows.size(); ++i)
      of_line[layout_.rows[i]] = i == 0 ? in_place_of_braces(layout_.row_values, fields[i]) : fields[i];
    for (size_t i = layout_.rows.size(); i < fields.size(); ++i) {
      if (fields[i].empty()) continue;
      if (!is_number(fields[i])) throw RecordError(fmt::format("\"{}\" is no number", fields[i]));
      PrintedNumber& number = numbers.emplace_back(PrintedNumber{of_line, fields[i]});
      // What a head says of itself wins: "serial" in a table of threads.
      for (const auto& [name, value] : columns_[i - layout_.rows.size()]) number.factors[name] = value;
    }
  }

  std::vector<PrintedNumber> numbers;

 private:
  const PublishedLayout& layout_;
  const std::string& quantity_;
  std::vector<std::string> heads_;
  std::vector<Factors> columns_;
};

}  // namespace

std::vector<PrintedNumber> read_published(const std::filesystem::path& file, const PublishedLayout& layout,
                                          const std::string& quantity) {
  std::ifstream in(file, std::ios::binary);
  if (!in) throw RecordError(fmt::format("{}: cannot be opened", file.string()));
  Reader reader(layout, quantity);
  std::string line;
  int number = 0;
  try {
    while (std::getline(in, line)) {
      number++;
      if (number == 1) {
        reader.read_head(line);
      } else {
        reader.read_line(line);
      }
    }
  } catch (const RecordError& error) {
    throw RecordError(fmt::format("{}:{}: not such a table: {}", file.string(), number, error.what()));
  }
  if (reader.numbers.empty()) throw RecordError(fmt::format("{}: has no numbers", file.string()));
  return std::move(reader.numbers);
}

double half_unit_of(const std::string& printed) {
  const size_t exponent_at = std::min(printed.find_first_of("eE"), printed.size());
  const size_t point = printed.find('.');
  const double decimals = point < exponent_at ? static_cast<double>(exponent_at - point - 1) : 0;
  const double exponent =
      exponent_at < printed.size() ? leading_number(printed.substr(exponent_at + 1)).value_or(0) : 0;
  return 0.5 * std::pow(10, exponent - decimals);
}

std::optional<std::vector<Observation>> observations_of(const PublishedTable& table,
                                                        const std::string& quantity) {
  const bool is_inverse = (table.quantity == "fps" && quantity == "frame_seconds") ||
                          (table.quantity == "frame_seconds" && quantity == "fps");
  if (table.quantity != quantity && !is_inverse) return std::nullopt;
  std::vector<Observation> list;
  std::set<Factors> known;
  for (const PrintedNumber& number : table.numbers) {
    if (!known.insert(number.factors).second) continue;
    Observation& made = list.emplace_back();
    made.factors = number.factors;
    made.value.value = leading_number(number.text).value_or(0) * table.scale;
    made.value.count = 1;
    made.half_unit = half_unit_of(number.text) * table.scale;
    if (!is_inverse) continue;
    made.half_unit /= made.value.value * made.value.value;
    made.value.value = 1 / made.value.value;
  }
  return list;
}

}  // namespace raysweep
