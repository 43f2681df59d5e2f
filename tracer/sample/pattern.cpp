#include "tracer/sample/pattern.h"

#include <fmt/format.h>

#include <charconv>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string_view>

#include "tracer/sample/point_sets.h"

namespace raysweep {

namespace {

/// A pattern's text, understood: either how to make its points or what is wrong with it.
struct Recipe {
  std::function<std::vector<Subpixel>(int count)> make;
  std::string problem;
};

/// The whole of `text` as a number, or nothing.
template <class T>
std::optional<T> parse(std::string_view text) {
  T value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

/// The comparisons are written so that NaN fails them.
Recipe circle_recipe(const std::string& pattern, std::string_view parameters) {
  const size_t colon = parameters.find(':');
  const auto radius = parse<double>(parameters.substr(0, colon));
  if (!radius || !(*radius > 0 && *radius <= 0.5))
    return {{}, pattern + ": the radius must be above 0 and at most 0.5 pixels"};
  const auto phase = colon == std::string_view::npos ? std::optional(default_circle_phase)
                                                     : parse<double>(parameters.substr(colon + 1));
  if (!phase || !(*phase >= 0 && *phase < 1))
    return {{}, pattern + ": the phase must be at least 0 and below 1 step between points"};
  return {[r = *radius, p = *phase](int count) { return make_circle(count, r, p); }, {}};
}

Recipe sobol_recipe(const std::string& pattern, std::string_view parameter) {
  const auto seed = parse<uint32_t>(parameter);
  if (!seed) return {{}, pattern + ": the seed must be a whole number from 0 to 4294967295"};
  return {[s = *seed](int count) { return make_sobol(count, s); }, {}};
}

Recipe recipe_of(const std::string& pattern) {
  constexpr std::string_view circle = "circle:", sobol = "sobol:";
  if (pattern == "grid") return {make_grid, {}};
  if (pattern == "rotated_grid") return {make_rotated_grid, {}};
  if (pattern == "circle")
    return {[](int count) { return make_circle(count, default_circle_radius, default_circle_phase); }, {}};
  if (pattern == "halton") return {make_halton, {}};
  if (pattern == "sobol") return {[](int count) { return make_sobol(count, 0); }, {}};
  if (pattern.starts_with(circle))
    return circle_recipe(pattern, std::string_view(pattern).substr(circle.size()));
  if (pattern.starts_with(sobol))
    return sobol_recipe(pattern, std::string_view(pattern).substr(sobol.size()));
  return {{},
          fmt::format("unknown pattern \"{}\"; possible: grid, rotated_grid, circle, circle:RADIUS, "
                      "circle:RADIUS:PHASE, halton, sobol, sobol:SEED",
                      pattern)};
}

}  // namespace

std::vector<Subpixel> make_pattern(const std::string& pattern, int count) {
  const Recipe recipe = recipe_of(pattern);
  if (!recipe.make) throw std::invalid_argument(recipe.problem);
  if (count < 1)
    throw std::invalid_argument(fmt::format("a pattern has at least 1 subpixel: {} is not possible", count));
  if (count == 1) return {{0.5, 0.5}};
  return recipe.make(count);
}

std::string pattern_problem(const std::string& pattern) { return recipe_of(pattern).problem; }

}  // namespace raysweep
