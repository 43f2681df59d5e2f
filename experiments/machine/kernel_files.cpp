#include "experiments/machine/kernel_files.h"

#include <fmt/format.h>

#include <fstream>
#include <sstream>

namespace raysweep {

namespace {

std::optional<double> number_in(const std::string& text) {
  std::istringstream in(text);
  double value = 0;
  if (in >> value) return value;
  return std::nullopt;
}

}  // namespace

std::optional<std::string> read_kernel_file(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  // Some files open and then refuse to be read; an empty one leaves `text` failed, not `in` bad.
  if (!in || in.peek() == std::ifstream::traits_type::eof()) {
    if (!in.is_open() || in.bad()) return std::nullopt;
    return std::string();
  }
  text << in.rdbuf();
  return text.str();
}

std::optional<std::string> first_line(const std::filesystem::path& file) {
  std::ifstream in(file);
  std::string line;
  if (!std::getline(in, line) && !in.eof()) return std::nullopt;
  if (!in.is_open() || in.bad()) return std::nullopt;
  const size_t begin = line.find_first_not_of(" \t");
  if (begin == std::string::npos) return std::string();
  return line.substr(begin, line.find_last_not_of(" \t") - begin + 1);
}

std::optional<double> first_number(const std::filesystem::path& file) {
  const auto line = first_line(file);
  return line ? number_in(*line) : std::nullopt;
}

std::optional<double> keyed_number(const std::filesystem::path& file, std::string_view key) {
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) {
    if (!line.starts_with(key)) continue;
    const std::string rest = line.substr(key.size());
    if (rest.starts_with(':')) return number_in(rest.substr(1));
    if (rest.starts_with(' ')) return number_in(rest);
  }
  return std::nullopt;
}

std::string unreadable(const std::filesystem::path& file) {
  return fmt::format("/{} cannot be read", file.string());
}

}  // namespace raysweep
