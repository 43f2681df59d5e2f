// The control groups that hold this process, which may share out its processor time (kernel documents
// admin-guide/cgroup-v2.rst and scheduler/sched-bwc.rst).
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

namespace raysweep {

/// Folders of this process's group and of those above it, as far as they can be seen, by version. In a
/// container what is above its own root is not seen.
struct ControlGroups {
  std::vector<std::filesystem::path> unified;  // version 2
  std::vector<std::filesystem::path> cpu;      // version 1, controller "cpu"
};

[[nodiscard]] ControlGroups control_groups(const std::filesystem::path& root = "/");

/// Processors that the groups allow: the least quota on the way up; infinite where none has one, none if no
/// group could be read.
[[nodiscard]] std::optional<double> cpu_quota(const ControlGroups& groups);

/// How long the groups have been stopped because their quota was used up, in seconds. None if no group
/// tells. Counted by each group for its own quota, hence summed.
[[nodiscard]] std::optional<double> throttled_seconds(const ControlGroups& groups);

}  // namespace raysweep
