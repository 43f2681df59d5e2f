// Files that appear whole or not at all.
#pragma once

#include <functional>
#include <iosfwd>
#include <string>

namespace raysweep {

/// Lets `write` fill `path`.part and renames that to `path`; on failure nothing of it stays. Throws
/// std::runtime_error "PATH: cannot be written: REASON", also for a std::exception out of `write`.
void write_whole_file(const std::string& path, const std::function<void(std::ostream& file)>& write);

}  // namespace raysweep
