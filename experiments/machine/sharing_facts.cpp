#include "experiments/machine/sharing_facts.h"

#include <array>
#include <sstream>

#include "experiments/machine/kernel_files.h"

namespace raysweep {

namespace fs = std::filesystem;

namespace {

/// Bit 31 of ECX of CPUID 1, kept free by processors for hypervisors, as Linux shows it. None where it shows
/// no flags (Arm calls them "Features", and has none for this).
std::optional<bool> hypervisor_flag(const fs::path& root) {
  std::istringstream lines(read_kernel_file(root / "proc/cpuinfo").value_or(""));
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("flags")) continue;
    return (line + " ").find(" hypervisor ") != std::string::npos;
  }
  return std::nullopt;
}

/// What virtual machines call themselves in the firmware's tables (as systemd's detect-virt knows them).
std::optional<std::string> virtual_product(const fs::path& root) {
  for (const char* file : {"product_name", "sys_vendor", "bios_vendor"}) {
    const auto line = first_line(root / "sys/class/dmi/id" / file);
    if (!line) continue;
    for (const char* name : {"KVM", "QEMU", "VMware", "VirtualBox", "Xen", "Bochs", "Parallels", "BHYVE",
                             "Amazon EC2", "Google Compute Engine", "Virtual Machine"})
      if (line->find(name) != std::string::npos) return name;
  }
  return std::nullopt;
}

Fact<std::string> virtual_machine(const fs::path& root) {
  const auto flag = hypervisor_flag(root);
  const auto product = virtual_product(root);
  // Amazon's machines without a hypervisor have its name in the tables too: where there is a flag, it
  // decides.
  if (flag) return std::string(!*flag ? "no" : product ? *product : "yes (hypervisor flag of the processor)");
  if (product) return *product;
  if (const auto type = first_line(root / "sys/hypervisor/type")) return *type;
  if (first_line(root / "sys/class/dmi/id/product_name")) return std::string("no");
  return Fact<std::string>::unknown("neither /proc/cpuinfo nor the firmware's tables tell");
}

/// Hints in the order of how sure they are.
Fact<std::string> container(const fs::path& root) {
  std::error_code ignored;
  if (fs::exists(root / ".dockerenv", ignored)) return std::string("docker");
  if (fs::exists(root / "run/.containerenv", ignored)) return std::string("podman");
  // Entries of an environment end with a zero byte; container managers set this one (systemd's container
  // interface).
  const auto environment = read_kernel_file(root / "proc/1/environ");
  std::istringstream entries(environment.value_or(""));
  for (std::string entry; std::getline(entries, entry, '\0');)
    if (entry.starts_with("container=")) return entry.substr(entry.find('=') + 1);
  const auto groups = read_kernel_file(root / "proc/1/cgroup");
  for (const char* name : {"docker", "kubepods", "containerd", "libpod", "lxc"})
    if (groups && groups->find(name) != std::string::npos) return std::string(name);
  if (environment) return std::string("no");
  return Fact<std::string>::unknown("nothing hints at one, but /proc/1/environ cannot be read");
}

}  // namespace

void read_sharing(const fs::path& root, MachineFacts& facts) {
  facts.virtual_machine = virtual_machine(root);
  facts.container = container(root);
}

}  // namespace raysweep
