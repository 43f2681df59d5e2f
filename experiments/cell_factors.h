// The one list of factors: how each is named, read from text, checked, and written. Configs sweep them,
// `render` takes them as options, launches get them from their parent.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "experiments/cell.h"

namespace raysweep {

struct CellFactor {
  std::string_view name;
  std::string_view possible;                            // values, for help texts
  bool numeric;                                         // configs may give numbers and ranges
  std::string (*set)(Cell&, const std::string& value);  // what is wrong with the value; empty if nothing is
  std::string (*text)(const Cell&);
};

[[nodiscard]] std::span<const CellFactor> cell_factors();

/// Null for an unknown name.
[[nodiscard]] const CellFactor* find_factor(std::string_view name);

/// Sets the factor. Throws RequestError with the factor's sentence.
void set_factor(Cell& cell, const CellFactor& factor, const std::string& value);

/// Throws RequestError if the factors, each possible, do not go together; `where` is the file that asks for
/// them, if any.
void refuse_impossible(const Cell& cell, const std::string& where = {});

/// Takes over a mode's numbers. Throws RequestError for an unknown mode.
void set_mode(Cell& cell, const std::string& mode);

}  // namespace raysweep
