#include "experiments/machine/control_groups.h"

#include <algorithm>
#include <limits>
#include <sstream>
#include <string>

#include "experiments/machine/kernel_files.h"

namespace raysweep {

namespace fs = std::filesystem;

namespace {

// What may not be looked at counts as not there.
bool is_folder(const fs::path& path) {
  std::error_code ignored;
  return fs::is_directory(path, ignored);
}
bool is_there(const fs::path& path) {
  std::error_code ignored;
  return fs::exists(path, ignored);
}

/// The folders of the group `path` and of its parents below `mount`, where they are there. The path may be
/// that of the host, of which a container sees only the top.
void add_folders(const fs::path& mount, std::string path, std::vector<fs::path>& folders) {
  std::error_code ignored;
  for (;; path = path.substr(0, path.rfind('/'))) {
    if (path == "/") path.clear();
    const fs::path folder = mount.string() + path;
    if (fs::is_directory(folder, ignored)) folders.push_back(folder);
    if (path.empty()) return;
  }
}

/// Whether `list`, of names with commas between, holds the controller "cpu".
bool has_cpu(const std::string& list) {
  std::istringstream names(list);
  for (std::string name; std::getline(names, name, ',');)
    if (name == "cpu") return true;
  return false;
}

/// "max 100000" or "50000 100000".
std::optional<double> unified_quota(const fs::path& folder) {
  const auto line = first_line(folder / "cpu.max");
  if (!line) return std::nullopt;
  if (line->starts_with("max")) return std::numeric_limits<double>::infinity();
  std::istringstream in(*line);
  double quota = 0, period = 0;
  if (in >> quota >> period && period > 0) return quota / period;
  return std::nullopt;
}

/// −1 where there is no quota.
std::optional<double> cpu_group_quota(const fs::path& folder) {
  const auto quota = first_number(folder / "cpu.cfs_quota_us");
  const auto period = first_number(folder / "cpu.cfs_period_us");
  if (!quota || !period || *period <= 0) return std::nullopt;
  return *quota < 0 ? std::numeric_limits<double>::infinity() : *quota / *period;
}

}  // namespace

ControlGroups control_groups(const fs::path& root) {
  ControlGroups groups;
  const fs::path mounts = root / "sys/fs/cgroup";
  std::istringstream lines(read_kernel_file(root / "proc/self/cgroup").value_or(""));
  for (std::string line; std::getline(lines, line);) {
    const size_t first = line.find(':'), second = line.find(':', first + 1);
    if (first == std::string::npos || second == std::string::npos) continue;
    const std::string controllers = line.substr(first + 1, second - first - 1),
                      path = line.substr(second + 1);
    if (line.starts_with("0::")) {
      // Beside version 1, version 2 is mounted below it and has other controllers.
      const bool beside = is_folder(mounts / "unified");
      add_folders(beside ? mounts / "unified" : mounts, path, groups.unified);
    } else if (has_cpu(controllers)) {
      const fs::path own = mounts / controllers;
      add_folders(is_folder(own) ? own : mounts / "cpu", path, groups.cpu);
    }
  }
  return groups;
}

std::optional<double> cpu_quota(const ControlGroups& groups) {
  std::optional<double> least;
  const auto take = [&](std::optional<double> quota) {
    if (quota) least = std::min(least.value_or(*quota), *quota);
  };
  for (const fs::path& folder : groups.unified) {
    take(unified_quota(folder));
    // The root group has no cpu.max, nor have groups without that controller: none of them has a quota.
    if (is_there(folder / "cgroup.controllers")) take(std::numeric_limits<double>::infinity());
  }
  for (const fs::path& folder : groups.cpu) {
    take(cpu_group_quota(folder));
    if (is_there(folder / "cpu.shares")) take(std::numeric_limits<double>::infinity());
  }
  return least;
}

std::optional<double> throttled_seconds(const ControlGroups& groups) {
  std::optional<double> sum;
  const auto add = [&](const fs::path& folder, const char* key, double unit) {
    if (const auto value = keyed_number(folder / "cpu.stat", key)) sum = sum.value_or(0) + *value * unit;
  };
  for (const fs::path& folder : groups.unified) add(folder, "throttled_usec", 1e-6);
  for (const fs::path& folder : groups.cpu) add(folder, "throttled_time", 1e-9);
  return sum;
}

}  // namespace raysweep
