#include "experiments/row_choice.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <sstream>

#include "experiments/errors.h"
#include "results/factors.h"

namespace raysweep {

namespace {

const FactorText& factor_of(const std::string& name, const std::string& text) {
  std::string names;
  for (const FactorText& factor : factor_texts()) {
    if (factor.name == name) return factor;
    names += fmt::format("{}{}", names.empty() ? "" : ", ", factor.name);
  }
  throw RequestError(fmt::format("--cell {}: unknown factor \"{}\"; possible: {}", text, name, names));
}

std::set<std::string> values_of(const std::vector<const CellRow*>& rows, const FactorText& factor) {
  std::set<std::string> values;
  for (const CellRow* row : rows) values.insert(factor.text(row->cell));
  return values;
}

/// What tells the rows apart: "threads (1, 2), chunk (1, 4)". A "-", of schedulers that have no use for a
/// factor, tells nobody apart whom the scheduler does not.
std::string differences(const std::vector<const CellRow*>& rows) {
  std::string text;
  for (const FactorText& factor : factor_texts()) {
    auto values = values_of(rows, factor);
    values.erase("-");
    if (values.size() < 2) continue;
    text += fmt::format("{}{} ({})", text.empty() ? "" : ", ", factor.name, fmt::join(values, ", "));
  }
  return text;
}

/// "a=1,b=0,2" has the conditions "a=1" and "b=0,2": lists of processors hold commas, too.
std::vector<std::string> conditions_of(const std::string& text) {
  std::vector<std::string> conditions;
  std::istringstream pieces(text);
  for (std::string piece; std::getline(pieces, piece, ',');) {
    if (piece.find('=') == std::string::npos && !conditions.empty()) {
      conditions.back() += "," + piece;
    } else {
      conditions.push_back(piece);
    }
  }
  return conditions;
}

}  // namespace

const CellRow& choose_row(const std::vector<CellRow>& rows, const std::string& text) {
  std::vector<const CellRow*> left;
  for (const CellRow& row : rows) left.push_back(&row);
  for (const std::string& condition : conditions_of(text)) {
    const size_t equals = condition.find('=');
    if (equals == std::string::npos) {
      throw RequestError(
          fmt::format("--cell {}: \"{}\" is no condition; write FACTOR=VALUE,FACTOR=VALUE", text, condition));
    }
    const FactorText& factor = factor_of(condition.substr(0, equals), text);
    const std::string value = condition.substr(equals + 1);
    const auto there = values_of(left, factor);
    std::erase_if(left, [&](const CellRow* row) { return factor.text(row->cell) != value; });
    if (left.empty()) {
      throw RequestError(fmt::format("--cell {}: no cell has {}; there is {} = {}", text, condition,
                                     factor.name, fmt::join(there, ", ")));
    }
  }
  if (left.empty()) throw RequestError(fmt::format("--cell {}: the run has no cells", text));
  if (left.size() > 1) {
    throw RequestError(
        fmt::format("--cell {}: {} cells are meant; name one by {}", text, left.size(), differences(left)));
  }
  return *left.front();
}

}  // namespace raysweep
