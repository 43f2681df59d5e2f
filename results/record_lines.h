// The lines of a records.jsonl, of whatever kind.
#pragma once

#include <filesystem>
#include <functional>
#include <nlohmann/json_fwd.hpp>

namespace raysweep {

/// Hands over each whole line of a file; a last one without its end (a writer that was killed) is left out.
/// Throws RecordError, with file and line, for a line that is no JSON or that `take` throws at.
void for_each_record_line(const std::filesystem::path& file,
                          const std::function<void(const nlohmann::json& line)>& take);

}  // namespace raysweep
