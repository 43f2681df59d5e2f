#include "results/power.h"

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <optional>

#include "results/comparison.h"
#include "results/rounds.h"
#include "results/tables/number_text.h"

namespace raysweep {

namespace {

constexpr int least_launches = 7, fewest_comparisons = 20;
constexpr double reliable = 0.8;  // the usual power (Cohen 1988)

/// A cell and its like, by round.
struct Study {
  std::map<int, const Record*> base, first_twin, second_twin;
  std::map<double, std::map<int, const Record*>> slowed;  // by planted slowdown
};

/// Where `r` belongs; null: nowhere.
std::map<int, const Record*>* list_of(Study& study, const Record& r) {
  if (r.slowdown > 0) return r.twin == 0 ? &study.slowed[r.slowdown] : nullptr;
  switch (r.twin) {
    case 0:
      return &study.base;
    case 1:
      return &study.first_twin;
    case 2:
      return &study.second_twin;
    default:
      return nullptr;
  }
}

std::optional<Study> find_study(const std::vector<Record>& records) {
  std::map<std::string, Study> studies;
  for (const Record& r : records) {
    if (!r.valid || r.processes > 1) continue;
    Study& study = studies[original_key(r)];
    if (auto* const list = list_of(study, r)) (*list)[r.round] = &r;
  }
  for (auto& [key, study] : studies) {
    if (!study.second_twin.empty() && !study.slowed.empty()) return std::move(study);
  }
  return std::nullopt;
}

/// Log ratios of fps and launch times of the rounds from `begin` to before `end` that both have.
struct Block {
  std::vector<double> log_ratios;
  double seconds = 0;  // of the first ones
};

Block block_of(const std::map<int, const Record*>& own, const std::map<int, const Record*>& base, int begin,
               int end) {
  Block block;
  for (auto it = own.lower_bound(begin); it != own.end() && it->first < end; ++it) {
    const auto other = base.find(it->first);
    if (other == base.end()) continue;
    block.log_ratios.push_back(std::log(it->second->fps() / other->second->fps()));
    block.seconds += it->second->launch_seconds;
  }
  return block;
}

Power power_of(const Study& study, int launches, int rounds) {
  Power power{launches, 0, 0, {{0, 0, 0}}};
  for (const auto& [planted, cells] : study.slowed) power.detections.push_back({planted, 0, 0});
  std::vector<NoiseFloor> floors;
  std::vector<double> seconds;
  for (int begin = 0; begin + launches <= rounds; begin += launches) {
    const Block twins = block_of(study.first_twin, study.base, begin, begin + launches);
    floors.push_back(noise_floor(twins.log_ratios, launches));
    seconds.push_back(3 * twins.seconds);
  }
  for (size_t i = 0; i < floors.size(); ++i) {
    // The floor of the block before: one from launches that are compared would be high where they differ.
    const NoiseFloor& floor = floors[(i + floors.size() - 1) % floors.size()];
    const int begin = static_cast<int>(i) * launches;
    for (Detection& detection : power.detections) {
      const auto& cell = detection.planted > 0 ? study.slowed.at(detection.planted) : study.second_twin;
      const Verdict verdict =
          verdict_of(paired_change(block_of(cell, study.base, begin, begin + launches).log_ratios), floor);
      detection.comparisons++;
      detection.found += verdict == Verdict::slower || (detection.planted == 0 && verdict == Verdict::faster);
    }
  }
  std::vector<double> known;
  for (const NoiseFloor& floor : floors) known.push_back(std::expm1(floor.log_ratio.value_or(0)));
  power.noise_floor = median(std::move(known));
  power.measuring_seconds = median(std::move(seconds));
  return power;
}

std::string percent_text(double share) { return fmt::format("{:.4g} %", share * 100); }

/// The least planted slowdown from which on all were found reliably; none if the largest was not.
std::optional<double> least_reliable(const Power& power) {
  std::optional<double> least;
  for (auto d = power.detections.rbegin(); d != power.detections.rend(); ++d) {
    if (d->planted == 0 || d->share() < reliable) break;
    least = d->planted;
  }
  return least;
}

std::string conclusion(const std::vector<Power>& all) {
  std::string text = "found at least 80 times of 100:";
  for (const Power& power : all) {
    const auto least = least_reliable(power);
    text +=
        fmt::format("{} {} with {} launches ({:.3g} s)", &power == &all.front() ? "" : ";",
                    least ? percent_text(*least) : "none of these", power.launches, power.measuring_seconds);
  }
  return text;
}

}  // namespace

std::vector<Power> detection_power(const std::vector<Record>& records) {
  std::vector<Power> all;
  const auto study = find_study(records);
  if (!study) return all;
  const int rounds = study->base.empty() ? 0 : study->base.rbegin()->first + 1;
  for (int launches = least_launches; rounds / launches >= fewest_comparisons; launches *= 2)
    all.push_back(power_of(*study, launches, rounds));
  return all;
}

Table power_table(const std::vector<Power>& power) {
  Table table;
  table.caption =
      "What one comparison alone finds, as of `compare --cell`: of a cell with itself (A/A: called "
      "different), and with "
      "one that is slowed down by a known share (called slower)\n" +
      conclusion(power);
  table.columns = {{"launches of each"}, {"A/A"}};
  for (const Detection& d : power.front().detections) {
    if (d.planted > 0) table.columns.push_back({"slower by " + percent_text(d.planted)});
  }
  table.columns.push_back({"noise floor"});
  table.columns.push_back({"measuring"});
  for (const Power& p : power) {
    std::vector<std::string> cells{std::to_string(p.launches)};
    for (const Detection& d : p.detections) {
      cells.push_back(fmt::format("{:.1f} % ({} of {})", d.share() * 100, d.found, d.comparisons));
    }
    cells.push_back(fmt::format("{:.2g} %", p.noise_floor * 100));
    cells.push_back(fmt::format("{:.3g} s", p.measuring_seconds));
    table.rows.push_back(std::move(cells));
  }
  return table;
}

Table power_data(const std::vector<Power>& power) {
  Table table;
  for (const char* title :
       {"launches", "planted", "comparisons", "found", "share", "noise_floor", "measuring_seconds"})
    table.columns.push_back({title});
  for (const Power& p : power) {
    for (const Detection& d : p.detections) {
      table.rows.push_back({std::to_string(p.launches), unrounded(d.planted), std::to_string(d.comparisons),
                            std::to_string(d.found), unrounded(d.share()), unrounded(p.noise_floor),
                            unrounded(p.measuring_seconds)});
    }
  }
  return table;
}

}  // namespace raysweep
