#include "results/factors.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

namespace raysweep {

const std::vector<FactorText>& factor_texts() {
  static const std::vector<FactorText> list{
      {"scene", [](const Record& r) { return r.scene; }, false},
      {"mode", [](const Record& r) { return r.mode; }, false},
      {"width", [](const Record& r) { return std::to_string(r.width); }, true},
      {"height", [](const Record& r) { return std::to_string(r.height); }, true},
      {"subpixels", [](const Record& r) { return std::to_string(r.subpixels); }, true},
      {"pattern", [](const Record& r) { return r.pattern; }, false},
      {"depth", [](const Record& r) { return std::to_string(r.depth); }, true},
      {"pixel_tolerance", [](const Record& r) { return fmt::format("{}", r.pixel_tolerance); }, true, "0"},
      {"branches", [](const Record& r) { return std::to_string(r.branches); }, true, "1024"},
      {"lights", [](const Record& r) { return std::to_string(r.lights); }, true},
      {"core", [](const Record& r) { return r.core; }, false},
      {"method", [](const Record& r) { return r.method; }, false},
      {"precision", [](const Record& r) { return r.precision; }, false},
      {"isa", [](const Record& r) { return r.isa; }, false, "baseline"},
      {"accel", [](const Record& r) { return r.accel; }, false},
      {"leaf", [](const Record& r) { return std::to_string(r.leaf); }, true},
      {"item", [](const Record& r) { return r.item; }, false},
      {"order", [](const Record& r) { return r.order; }, false, "scanline"},
      {"wait_policy", [](const Record& r) { return r.wait_policy; }, false, "default"},
      {"spin_count", [](const Record& r) { return r.spin_count; }, true, "default"},
      {"environment", [](const Record& r) { return r.environment; }, false, ""},
      {"pin", [](const Record& r) { return r.pin; }, false},
      {"slowdown", [](const Record& r) { return fmt::format("{}", r.slowdown); }, true, "0"},
      {"scheduler", [](const Record& r) { return r.scheduler; }, false},
      {"runtime", [](const Record& r) { return r.runtime; }, false},
      {"chunk", [](const Record& r) { return r.chunk; }, true},
      {"threads", [](const Record& r) { return std::to_string(r.threads); }, true},
  };
  return list;
}

namespace {

/// Whether the mode's name alone decides this factor in every row.
bool follows_from_mode(const std::vector<CellRow>& rows, const FactorText& factor) {
  static const std::set<std::string> details{"width", "height", "subpixels", "depth", "lights"};
  if (!details.contains(factor.name)) return false;
  std::map<std::string, std::set<std::string>> values;
  for (const CellRow& row : rows) values[row.cell.mode].insert(factor.text(row.cell));
  return std::ranges::all_of(values, [](const auto& of_mode) { return of_mode.second.size() == 1; });
}

std::set<std::string> values_of(const std::vector<CellRow>& rows, const FactorText& factor) {
  std::set<std::string> values;
  for (const CellRow& row : rows) values.insert(factor.text(row.cell));
  values.erase("-");
  return values;
}

}  // namespace

std::vector<FactorText> varying_factors(const std::vector<CellRow>& rows) {
  std::vector<FactorText> varying;
  for (const FactorText& factor : factor_texts()) {
    const bool always = factor.name == "scheduler" || factor.name == "threads";
    const bool varies = values_of(rows, factor).size() > 1 && !follows_from_mode(rows, factor);
    if (always || varies) varying.push_back(factor);
  }
  return varying;
}

std::string constant_factors(const std::vector<CellRow>& rows, const std::vector<FactorText>& varying) {
  std::string text;
  for (const FactorText& factor : factor_texts()) {
    if (std::ranges::any_of(varying, [&](const FactorText& f) { return f.name == factor.name; })) continue;
    const auto values = values_of(rows, factor);
    if (values.size() != 1 || *values.begin() == factor.usual) continue;
    // Two lines: what is rendered, and how.
    const char* const separator = text.empty() ? "" : factor.name == "core" ? "\n" : " · ";
    text += fmt::format("{}{} {}", separator, factor.name, *values.begin());
  }
  return text;
}

}  // namespace raysweep
