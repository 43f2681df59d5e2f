// How a factor's value is read from text and checked. Each function sets it in a cell, or tells what is wrong
// with the text; empty if nothing is.
#pragma once

#include <span>
#include <string>

#include "experiments/cell.h"

namespace raysweep {

[[nodiscard]] std::string set_int(const char* name, int& target, const std::string& value, Range range);
[[nodiscard]] std::string set_choice(const char* name, std::string& target, const std::string& value,
                                     std::span<const Choice> choices);

/// A count, or "scene" for the scene's own.
[[nodiscard]] std::string set_lights(Cell& cell, const std::string& value);
[[nodiscard]] std::string set_pixel_tolerance(Cell& cell, const std::string& value);
[[nodiscard]] std::string set_slowdown(Cell& cell, const std::string& value);
/// One of methods(); "auto" is none, and its sentence says who understands it.
[[nodiscard]] std::string set_method(Cell& cell, const std::string& value);
[[nodiscard]] std::string set_pattern(Cell& cell, const std::string& value);
[[nodiscard]] std::string set_isa(Cell& cell, const std::string& value);
[[nodiscard]] std::string set_scheduler(Cell& cell, const std::string& value);
[[nodiscard]] std::string set_runtime(Cell& cell, const std::string& value);
[[nodiscard]] std::string set_item(Cell& cell, const std::string& value);
[[nodiscard]] std::string set_chunk(Cell& cell, const std::string& value);
[[nodiscard]] std::string set_pin(Cell& cell, const std::string& value);
[[nodiscard]] std::string set_spin_count(Cell& cell, const std::string& value);
/// Only what runtimes read when they are loaded, since other variables would be too late for this process;
/// and not what has a factor of its own.
[[nodiscard]] std::string set_environment(Cell& cell, const std::string& value);

}  // namespace raysweep
