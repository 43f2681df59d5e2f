#include "results/run_comparison.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "results/factors.h"
#include "results/rounds.h"
#include "results/spoilers.h"
#include "results/tables/comparison_text.h"

namespace raysweep {

namespace {

constexpr double other_speed = 0.02;  // the half-width that intervals aim at by default

/// "thread_static, 2 threads, chunk 4"
std::string name_of(const Record& r, const std::vector<FactorText>& varying) {
  std::string name = fmt::format("{}, {} thread{}", r.scheduler, r.threads, r.threads == 1 ? "" : "s");
  for (const FactorText& f : varying) {
    if (f.name == "scheduler" || f.name == "threads" || f.text(r) == "-") continue;
    name += fmt::format(", {} {}", f.name, f.text(r));
  }
  return name;
}

std::vector<double> logs_of(const CellRow& row) {
  std::vector<double> logs;
  for (const auto& [round, fps] : row.fps_by_round) logs.push_back(std::log(fps));
  return logs;
}

/// An unknown hash (no valid launch, an old record) differs from none.
bool other_picture(const CellRow& a, const CellRow& b) {
  return !a.cell.image_hash.empty() && !b.cell.image_hash.empty() && a.cell.image_hash != b.cell.image_hash;
}

NoiseFloor larger(const NoiseFloor& a, const NoiseFloor& b) {
  if (!a.log_ratio) return a;
  if (!b.log_ratio) return b;
  return *a.log_ratio > *b.log_ratio ? a : b;
}

CellComparison row_of(const CellRow* a, const CellRow* b) {
  CellComparison row;
  row.cell = (a ? a : b)->cell;
  if (a) row.fps_a = a->fps;
  if (b) row.fps_b = b->fps;
  if (!a || !b) {
    row.not_compared = a ? "only in A" : "only in B";
  } else if (other_picture(*a, *b)) {
    row.not_compared = "not comparable: they rendered different pictures";
  }
  return row;
}

/// Changes of all rows that can be compared, at the confidence that their number asks for.
template <class ChangeOf>
void compare(RunComparison& made, ChangeOf&& change_of) {
  const auto compared = [](const CellComparison& row) { return row.not_compared.empty(); };
  const double confidence =
      simultaneous_confidence(static_cast<size_t>(std::ranges::count_if(made.rows, compared)));
  std::vector<double> p;
  for (size_t i = 0; i < made.rows.size(); ++i) {
    CellComparison& row = made.rows[i];
    if (!compared(row)) continue;
    row.change = change_of(i, confidence);
    row.verdict = verdict_of(row.change, made.floor);
    p.push_back(row.change ? row.change->p : 1);
  }
  const auto adjusted_p = holm(p);
  auto adjusted = adjusted_p.begin();
  for (CellComparison& row : made.rows) {
    if (!compared(row)) continue;
    if (row.change) row.adjusted_p = *adjusted;
    ++adjusted;
  }
}

MachineRecord machine_of(const RunData& run) {
  const auto row = std::ranges::find_if(run.rows, [](const CellRow& r) { return r.launches > 0; });
  return row == run.rows.end() ? MachineRecord() : row->cell.machine;
}

bool is_same(const MachineRecord& a, const MachineRecord& b) {
  return a.host == b.host && a.cpu == b.cpu && a.pus == b.pus;
}

std::vector<std::string> machine_warnings(const RunData& a, const RunData& b) {
  const MachineRecord on_a = machine_of(a), on_b = machine_of(b);
  if (!is_same(on_a, on_b)) {
    return {
        fmt::format("the runs were made on different machines: A on {} ({}, {} processors), B on {} ({}, {} "
                    "processors)",
                    on_a.host, on_a.cpu, on_a.pus, on_b.host, on_b.cpu, on_b.pus)};
  }
  std::vector<std::string> warnings{
      "A and B were measured one after the other: what the machine did otherwise meanwhile counts as their "
      "difference; cells of one run are compared round by round"};
  const auto spin_a = usual_spin_seconds(a.records), spin_b = usual_spin_seconds(b.records);
  if (spin_a && spin_b && std::abs(*spin_b / *spin_a - 1) > other_speed) {
    warnings.push_back(
        fmt::format("the processor itself ran at another speed: the calibrated spin took {} in B",
                    signed_percent(*spin_b / *spin_a)));
  }
  return warnings;
}

/// "B is faster in 3 of 12 cells, slower in 1 (worst −4.1 % [−5.0, −3.2]: …), no difference shown in 8"
std::string verdict_sentence(const RunComparison& made) {
  size_t faster = 0, slower = 0, same = 0, few = 0, unlike = 0;
  const CellComparison* worst = nullptr;
  for (const CellComparison& row : made.rows) {
    if (!row.not_compared.empty()) {
      unlike++;
      continue;
    }
    faster += row.verdict == Verdict::faster;
    slower += row.verdict == Verdict::slower;
    same += row.verdict == Verdict::no_difference;
    few += row.verdict == Verdict::too_few;
    if (row.verdict == Verdict::slower && (!worst || row.change->ratio < worst->change->ratio)) worst = &row;
  }
  const size_t compared = made.rows.size() - unlike;
  if (compared == 0) return "no cell can be compared";
  std::string text = fmt::format("B is faster in {} of {} cell{}, slower in {}", faster, compared,
                                 compared == 1 ? "" : "s", slower);
  if (worst) text += fmt::format(" (worst {}: {})", signed_amount(*worst->change), worst->name);
  text += fmt::format(", no difference shown in {}", same);
  if (few > 0) text += fmt::format(", too few launches in {}", few);
  if (unlike > 0) text += fmt::format("; not compared: {}", unlike);
  return text + (made.floor.log_ratio ? "" : "; noise floor unknown");
}

}  // namespace

bool RunComparison::slower_than(double share) const {
  return std::ranges::any_of(rows, [share](const CellComparison& row) {
    return row.verdict == Verdict::slower && 1 - row.change->ratio > share;
  });
}

std::string RunComparison::unanswered() const {
  if (!same_machine) return "the runs were made on different machines";
  for (const CellComparison& row : rows) {
    if (!row.fps_a || row.change) continue;
    return fmt::format("{} could not be compared: {}", row.name,
                       row.not_compared.empty() ? "fewer than 6 launches on one side" : row.not_compared);
  }
  return rows.empty() ? "there is no cell that could be compared" : "";
}

RunComparison compare_runs(const RunData& a, const RunData& b) {
  std::map<std::string, const CellRow*> in_b;
  for (const CellRow& row : b.rows) in_b[own_key(row.cell)] = &row;
  RunComparison made;
  made.floor = larger(a.context.floor, b.context.floor);
  made.warnings = machine_warnings(a, b);
  made.same_machine = is_same(machine_of(a), machine_of(b));
  std::vector<std::pair<const CellRow*, const CellRow*>> pairs;
  std::vector<CellRow> all = a.rows;
  for (const CellRow& row : a.rows) {
    const auto found = in_b.find(own_key(row.cell));
    pairs.emplace_back(&row, found == in_b.end() ? nullptr : found->second);
    if (found != in_b.end()) in_b.erase(found);
  }
  for (const CellRow& row : b.rows) {
    if (!in_b.contains(own_key(row.cell))) continue;
    pairs.emplace_back(nullptr, &row);
    all.push_back(row);
  }
  const auto varying = varying_factors(all);
  for (const auto& [of_a, of_b] : pairs) {
    made.rows.push_back(row_of(of_a, of_b));
    made.rows.back().name = name_of(made.rows.back().cell, varying);
  }
  compare(made, [&](size_t i, double confidence) {
    return unpaired_change(logs_of(*pairs[i].second), logs_of(*pairs[i].first), confidence);
  });
  made.sentence = verdict_sentence(made);
  return made;
}

RunComparison compare_cells(const RunData& run, const CellRow& a, const CellRow& b) {
  RunComparison made;
  made.floor = run.context.floor;
  made.rows.push_back(row_of(&a, &b));
  CellComparison& row = made.rows.front();
  const auto varying = varying_factors({a, b});
  row.cell = b.cell;
  row.name = name_of(b.cell, varying);
  compare(made, [&](size_t, double confidence) {
    return paired_change(log_ratios(b.fps_by_round, a.fps_by_round), confidence);
  });
  made.sentence = row.not_compared.empty()
                      ? in_a_sentence(row.name, name_of(a.cell, varying), row.change, made.floor)
                      : row.not_compared;
  return made;
}

}  // namespace raysweep
