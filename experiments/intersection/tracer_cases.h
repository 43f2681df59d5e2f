// Cases of the failure catalogue that no single ray and triangle can show: tests of the tracer judge them.
#pragma once

#include <span>
#include <string_view>

namespace raysweep {

struct TracerCase {
  std::string_view id, title, source;
  std::string_view checked_in;  // the file, from the project's root; its tests' names begin with the id
};

/// F3, I1, N1, N3, N5, N7, P1–P3, V1, V2 and W8; with `all_cases` these are all that the catalogue has.
[[nodiscard]] std::span<const TracerCase> tracer_cases();

}  // namespace raysweep
