// Small files of /proc and /sys. A file that is missing or unreadable is no answer, never an error: which of
// them there are depends on kernel, processor, container and permissions.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace raysweep {

/// The whole file.
[[nodiscard]] std::optional<std::string> read_kernel_file(const std::filesystem::path& file);

/// Its first line, without the blanks around it.
[[nodiscard]] std::optional<std::string> first_line(const std::filesystem::path& file);

/// The number that it begins with.
[[nodiscard]] std::optional<double> first_number(const std::filesystem::path& file);

/// The number after `key` in a file of lines "key 123" or "key: 123 kB" (cpu.stat, /proc/meminfo).
[[nodiscard]] std::optional<double> keyed_number(const std::filesystem::path& file, std::string_view key);

/// "/proc/meminfo cannot be read", of a file below the root.
[[nodiscard]] std::string unreadable(const std::filesystem::path& file);

}  // namespace raysweep
