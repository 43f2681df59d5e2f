#include "results/best.h"

#include <algorithm>
#include <map>
#include <set>

#include "results/factors.h"
#include "results/tables/comparison_text.h"

namespace raysweep {

namespace {

/// What decides who computes which pixel when and where, and nothing of the picture.
const std::set<std::string> of_the_work{"scheduler", "runtime",     "item",       "order",       "chunk",
                                        "pin",       "wait_policy", "spin_count", "environment", "slowdown"};

std::string group_key(const Record& r) {
  std::string key;
  for (const FactorText& f : factor_texts()) {
    if (!of_the_work.contains(f.name)) key += f.text(r) + "|";
  }
  return key;
}

using Group = std::vector<size_t>;  // numbers of rows, the best one first

/// The median of the rounds that all rows of the group share: medians of others may be of better times.
std::map<size_t, double> medians_of(const std::vector<CellRow>& rows, const Group& group) {
  std::map<size_t, std::vector<double>> shared;
  for (const auto& [round, fps] : rows[group.front()].fps_by_round) {
    const auto has_round = [&rows, round = round](size_t i) { return rows[i].fps_by_round.contains(round); };
    if (!std::ranges::all_of(group, has_round)) continue;
    for (const size_t i : group) shared[i].push_back(rows[i].fps_by_round.at(round));
  }
  std::map<size_t, double> medians;
  for (const size_t i : group) medians[i] = shared[i].empty() ? rows[i].fps->value : median(shared[i]);
  return medians;
}

std::vector<Group> groups_of(const std::vector<CellRow>& rows) {
  std::map<std::string, Group> by_key;
  for (size_t i = 0; i < rows.size(); ++i) {
    if (rows[i].fps) by_key[group_key(rows[i].cell)].push_back(i);
  }
  std::vector<Group> groups;
  for (auto& [key, group] : by_key) {
    if (group.size() < 2) continue;
    const auto medians = medians_of(rows, group);
    std::ranges::stable_sort(group, std::greater(), [&](size_t i) { return medians.at(i); });
    groups.push_back(std::move(group));
  }
  return groups;
}

/// Of all pairs of rows, those of a group with its best first.
std::vector<std::optional<Change>> compare_pairs(const std::vector<CellRow>& rows, const Group& group,
                                                 double confidence) {
  std::vector<std::optional<Change>> changes;
  for (size_t a = 0; a < group.size(); ++a) {
    for (size_t b = a + 1; b < group.size(); ++b) {
      const auto ratios = log_ratios(rows[group[b]].fps_by_round, rows[group[a]].fps_by_round);
      changes.push_back(paired_change(ratios, confidence));
    }
  }
  return changes;
}

void place(const Group& group, const std::optional<Change>* changes, const double* adjusted_p,
           const NoiseFloor& floor, std::vector<Standing>& standings) {
  Standing& best = standings[group.front()];
  best.place = Standing::Place::best;
  best.shown = true;
  for (size_t i = 1; i < group.size(); ++i) {
    Standing& other = standings[group[i]];
    other.place = Standing::Place::other;
    other.change = changes[i - 1];
    other.verdict = verdict_of(other.change, floor);
    if (other.change) other.adjusted_p = adjusted_p[i - 1];
    best.shown &= other.verdict == Verdict::slower;
  }
}

}  // namespace

std::string Standing::to_text(const NoiseFloor& floor) const {
  if (place == Place::alone) return "";
  if (place == Place::best) return shown ? "fastest" : "best median";
  return in_words(change, floor);
}

Standings against_the_best(const std::vector<CellRow>& rows, const NoiseFloor& floor) {
  const auto groups = groups_of(rows);
  Standings standings{std::vector<Standing>(rows.size()), 0};
  for (const Group& group : groups) {
    const size_t pairs = group.size() * (group.size() - 1) / 2;
    standings.comparisons = std::max(standings.comparisons, pairs);
    const auto changes = compare_pairs(rows, group, simultaneous_confidence(pairs));
    std::vector<double> p;
    for (const auto& change : changes) p.push_back(change ? change->p : 1);
    const auto adjusted = holm(p);
    place(group, changes.data(), adjusted.data(), floor, standings.rows);
  }
  return standings;
}

}  // namespace raysweep
