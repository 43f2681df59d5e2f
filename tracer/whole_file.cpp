#include "tracer/whole_file.h"

#include <fmt/core.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace raysweep {

namespace {

/// Empty if `part` was written, otherwise why not.
std::string write_part(const std::string& part, const std::function<void(std::ostream&)>& write) {
  errno = 0;
  std::ofstream file(part, std::ios::binary);
  try {
    if (file) write(file);
  } catch (const std::exception& error) {
    return error.what();
  }
  file.close();
  if (file) return {};
  return errno ? std::strerror(errno) : "the file takes no more";
}

}  // namespace

std::string part_of(const std::string& path) { return fmt::format("{}.{}.part", path, getpid()); }

void write_whole_file(const std::string& path, const std::function<void(std::ostream& file)>& write) {
  const std::string part = part_of(path);
  std::string reason = write_part(part, write);
  std::error_code error;
  if (reason.empty()) {
    std::filesystem::rename(part, path, error);
    if (!error) return;
    reason = error.message();
  }
  std::filesystem::remove(part, error);
  throw std::runtime_error(fmt::format("{}: cannot be written: {}", path, reason));
}

}  // namespace raysweep
