// Instruction sets that the wide core is compiled for.
#pragma once

#include <span>
#include <string_view>

namespace raysweep {

struct Isa {
  std::string_view name, summary;
  int width;  // children of a node, triangles of a block
};

/// In this program, best first.
[[nodiscard]] std::span<const Isa> built_isas();

/// Whether this machine's processors have it and it is in this program.
[[nodiscard]] bool runs_here(std::string_view isa);

/// The best one that runs here.
[[nodiscard]] std::string_view best_isa();

}  // namespace raysweep
