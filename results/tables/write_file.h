// Tables on disk.
#pragma once

#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

namespace raysweep {

/// Throws std::runtime_error where it cannot be written whole.
inline void write_file(const std::filesystem::path& file, const std::string& text) {
  std::ofstream out(file, std::ios::binary);
  out << text;
  out.close();
  if (!out) throw std::runtime_error(file.string() + ": cannot be written");
}

}  // namespace raysweep
