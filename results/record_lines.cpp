#include "results/record_lines.h"

#include <fmt/format.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "results/record.h"

namespace raysweep {

void for_each_record_line(const std::filesystem::path& file,
                          const std::function<void(const nlohmann::json& line)>& take) {
  std::ifstream in(file, std::ios::binary);
  if (!in) throw RecordError(fmt::format("{}: cannot be opened", file.string()));
  std::string line;
  for (int number = 1; std::getline(in, line); ++number) {
    if (in.eof()) break;  // no newline: the writer was stopped inside this line
    try {
      take(nlohmann::json::parse(line));
    } catch (const std::exception& error) {
      throw RecordError(fmt::format("{}:{}: not a record: {}", file.string(), number, error.what()));
    }
  }
}

}  // namespace raysweep
