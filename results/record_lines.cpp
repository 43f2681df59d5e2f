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

std::string record_line(const nlohmann::json& record) {
  return record.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

void expect_record(const nlohmann::json& record, std::string_view kind, int schema) {
  if (const auto found = record.at("kind").get<std::string>(); found != kind)
    throw RecordError(fmt::format("kind \"{}\" where \"{}\" was expected", found, kind));
  if (const int found = record.at("schema").get<int>(); found != schema)
    throw RecordError(fmt::format("schema {} is unknown here; this version reads {}", found, schema));
}

}  // namespace raysweep
