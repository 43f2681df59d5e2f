#include "experiments/overhead/metg.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "experiments/overhead/numbers_text.h"

namespace raysweep {

namespace {

/// Between two sizes of which only the larger one reaches the bound.
double crossing(const TaskSize& below, const TaskSize& above, double bound) {
  const double share = (bound - below.efficiency) / (above.efficiency - below.efficiency);
  return below.nanoseconds * std::pow(above.nanoseconds / below.nanoseconds, share);
}

}  // namespace

std::optional<Metg> find_metg(std::vector<TaskSize> sizes, double bound) {
  if (sizes.empty()) return std::nullopt;
  std::ranges::sort(sizes, {}, &TaskSize::nanoseconds);
  const auto reaches = [bound](const TaskSize& size) { return size.efficiency >= bound; };
  const auto last_below = std::find_if_not(sizes.rbegin(), sizes.rend(), reaches);
  if (last_below == sizes.rend()) return Metg{Metg::Kind::at_most, sizes.front().nanoseconds};
  const bool noisy = std::any_of(last_below, sizes.rend(), reaches);
  if (last_below == sizes.rbegin()) return Metg{Metg::Kind::above, sizes.back().nanoseconds, noisy};
  return Metg{Metg::Kind::bracketed, crossing(*last_below, *std::prev(last_below), bound), noisy};
}

std::string metg_text(const std::optional<Metg>& metg) {
  if (!metg) return "–";
  std::string time = duration_text(metg->nanoseconds);
  if (metg->kind == Metg::Kind::bracketed) return time;
  return fmt::format("not bracketed ({} {})", metg->kind == Metg::Kind::at_most ? "≤" : ">", time);
}

}  // namespace raysweep
