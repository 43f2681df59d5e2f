// The lines of a records.jsonl, of whatever kind.
#pragma once

#include <filesystem>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

namespace raysweep {

/// Hands over each whole line of a file; a last one without its end (a writer that was killed) is left out.
/// Throws RecordError, with file and line, for a line that is no JSON or that `take` throws at.
void for_each_record_line(const std::filesystem::path& file,
                          const std::function<void(const nlohmann::json& line)>& take);

/// The line of a record, without its newline.
[[nodiscard]] std::string record_line(const nlohmann::json& record);

/// Throws RecordError for a record of another kind or schema.
void expect_record(const nlohmann::json& record, std::string_view kind, int schema);

}  // namespace raysweep
