// Numbers of claims as formulas of the machine that they are judged on: "2*pus", "cores >= 6 and smt".
#pragma once

#include <stdexcept>
#include <string>

namespace raysweep {

/// The machine whose numbers are judged; 0: unknown.
struct MachineCounts {
  int cores = 0, pus = 0;  // physical cores, and processors

  [[nodiscard]] bool is_known() const { return cores > 0 && pus > 0; }
};

/// Thrown for what is no formula, or needs a machine that is not known; a sentence without its place.
struct ExpressionError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// What `text` comes to with cores, pus and smt (true where there are more processors than cores);
/// truths come to 1 and 0. Operators are those of
/// muParserX, `and` and `or` among them. (Debian's muParser would bring an OpenMP runtime into every
/// process.)
[[nodiscard]] double evaluate(const std::string& text, const MachineCounts& machine);

/// Whether `text` names cores, pus or smt.
[[nodiscard]] bool mentions_machine(const std::string& text);

}  // namespace raysweep
