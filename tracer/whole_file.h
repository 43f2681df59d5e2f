// Files that appear whole or not at all.
#pragma once

#include <functional>
#include <iosfwd>
#include <string>

namespace raysweep {

/// The unfinished file's name beside `path`: one of this process's own, so that nobody's file is lost.
[[nodiscard]] std::string part_of(const std::string& path);

/// Lets `write` fill `part_of(path)` and renames that to `path`; on failure nothing of it stays. Throws
/// std::runtime_error "PATH: cannot be written: REASON", also for a std::exception out of `write`.
void write_whole_file(const std::string& path, const std::function<void(std::ostream& file)>& write);

}  // namespace raysweep
