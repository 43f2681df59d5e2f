// What the system was asked for, as it tells itself.
#include <gtest/gtest.h>
#include <sys/mman.h>

#include <cstdint>
#include <fstream>
#include <sstream>

#include "tracer/unset_memory.h"

namespace raysweep {
namespace {

/// Whether the mapping that holds `address` is marked for huge pages ("hg", proc(5)).
bool wants_huge_pages(const void* address) {
  const auto wanted = reinterpret_cast<std::uintptr_t>(address);
  std::ifstream file("/proc/self/smaps");
  bool is_inside = false;
  for (std::string line; std::getline(file, line);) {
    std::istringstream words(line);
    std::uintptr_t begin = 0, end = 0;
    char dash = 0;
    if (words >> std::hex >> begin >> dash >> end && dash == '-') is_inside = begin <= wanted && wanted < end;
    if (is_inside && line.starts_with("VmFlags:")) return line.find(" hg") != std::string::npos;
  }
  return false;
}

/// Not so without such pages, and not on an emulated processor.
bool grants_wishes() {
  constexpr size_t bytes = 2 * least_huge_array;
  void* const memory = mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED) return false;
  const bool granted = madvise(memory, bytes, MADV_HUGEPAGE) == 0 && wants_huge_pages(memory);
  munmap(memory, bytes);
  return granted;
}

TEST(huge_pages, are_asked_for_where_arrays_are_large) {
  if (!grants_wishes()) GTEST_SKIP() << "this system has none, or does not tell";
  const UnsetVector<char> large(16 * least_huge_array);
  EXPECT_TRUE(wants_huge_pages(large.data() + large.size() / 2));
}

}  // namespace
}  // namespace raysweep
