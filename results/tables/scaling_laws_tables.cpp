#include "results/tables/scaling_laws_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "results/factors.h"
#include "results/tables/number_text.h"

namespace raysweep {

namespace {

std::string group_key(const Record& r) {
  std::string key;
  for (const FactorText& f : factor_texts()) {
    if (f.name != "threads") key += f.text(r) + "|";
  }
  return key;
}

/// Threads that share a core are another regime, whether the machine has too few cores or they are bound so.
bool has_core_each(const Record& r) {
  return !r.is_bound() || r.cores_seen == 0 || r.threads <= r.cores_seen;
}

/// Medians of the rounds that all rows share: a machine that drifts while some rows are launched on must not
/// bend the curve.
ScalingLaws laws_of(std::vector<const CellRow*> rows) {
  const int cores = rows.front()->cell.machine.cores;
  std::erase_if(rows, [](const CellRow* row) { return !has_core_each(row->cell) || row->oversubscribed; });
  std::vector<std::vector<double>> shared(rows.size());
  for (size_t i = 0; i < rows.size(); ++i) {
    for (const auto& [round, fps] : rows[i]->fps_by_round) {
      const auto has_round = [round = round](const CellRow* row) {
        return row->fps_by_round.contains(round);
      };
      if (std::ranges::all_of(rows, has_round)) shared[i].push_back(fps);
    }
  }
  std::vector<ScalingPoint> points;
  for (size_t i = 0; i < rows.size(); ++i)
    points.push_back({rows[i]->cell.threads, shared[i].empty() ? rows[i]->fps->value : median(shared[i])});
  return fit_scaling_laws(std::move(points), cores);
}

/// Against `serial`. What threads lose that have no processor or core of their own is no serial share.
std::optional<Estimate> serial_share(const CellRow& row) {
  if (row.oversubscribed || !has_core_each(row.cell) || row.cell.threads > row.cell.machine.cores)
    return std::nullopt;
  return karp_flatt(row.speedup, row.cell.threads);
}

std::string peak_text(const ScalingLaws& laws) {
  if (!laws.usl) return "–";
  if (!laws.usl->peak_threads) return "not shown";
  return fmt::format("{:.3g} threads{}", *laws.usl->peak_threads,
                     laws.usl->extrapolated ? " (extrapolated)" : "");
}

std::string remark(const ScalingLaws& laws) {
  if (!laws.refused.empty()) return laws.refused;
  std::string text;
  const auto add = [&](const std::string& what) { text.append(text.empty() ? "" : "; ").append(what); };
  if (laws.amdahl->superlinear) add("Amdahl: superlinear (its serial share is negative)");
  if (laws.usl->superlinear) {
    add(fmt::format("USL: superlinear ({} is negative)",
                    laws.usl->serial_share.value < laws.usl->coherence->value ? "σ" : "κ"));
  }
  return text;
}

std::vector<std::string> law_cells(const ScalingLaws& laws) {
  if (!laws.usl) return {"–", "–", "–", "–", remark(laws)};
  return {percent(std::optional(laws.amdahl->serial_share)), percent(std::optional(laws.usl->serial_share)),
          with_interval(laws.usl->coherence), peak_text(laws), remark(laws)};
}

std::vector<std::string> law_data(const ScalingLaws& laws) {
  std::vector<std::string> cells{std::to_string(laws.points)};
  const auto add = [&](const std::optional<Estimate>& e) {
    for (std::string& number : unrounded(e)) cells.push_back(std::move(number));
  };
  const auto& [points, amdahl, usl, refused] = laws;
  cells.push_back(amdahl ? fmt::format("{}", amdahl->fps_of_one) : "");
  add(amdahl ? std::optional(amdahl->serial_share) : std::nullopt);
  cells.push_back(usl ? fmt::format("{}", usl->fps_of_one) : "");
  add(usl ? std::optional(usl->serial_share) : std::nullopt);
  add(usl ? usl->coherence : std::nullopt);
  cells.push_back(usl ? unrounded(usl->peak_threads) : "");
  cells.push_back(usl && usl->extrapolated ? "1" : "0");
  cells.push_back(remark(laws));
  return cells;
}

}  // namespace

std::vector<ScalingGroup> scaling_groups(const std::vector<CellRow>& rows) {
  std::vector<std::string> order;
  std::map<std::string, std::vector<const CellRow*>> by_key;
  for (const CellRow& row : rows) {
    if (!row.fps) continue;
    const std::string key = group_key(row.cell);
    if (!by_key.contains(key)) order.push_back(key);
    by_key[key].push_back(&row);
  }
  std::vector<ScalingGroup> groups;
  for (const std::string& key : order) {
    auto& group = by_key[key];
    std::ranges::stable_sort(group, {}, [](const CellRow* row) { return row->cell.threads; });
    if (group.front()->cell.threads < group.back()->cell.threads) groups.push_back({group, laws_of(group)});
  }
  return groups;
}

bool any_law(const std::vector<ScalingGroup>& groups) {
  return std::ranges::any_of(groups, [](const ScalingGroup& g) { return g.laws.refused.empty(); });
}

Table scaling_laws_table(const std::vector<CellRow>& rows) {
  const auto factors = varying_factors(rows);
  Table table;
  table.caption =
      "Scaling laws: Karp–Flatt's serial share (1/S − 1/p)/(1 − 1/p) of threads with a core each, by the "
      "speedup "
      "against serial and its interval\n"
      "fits to log fps up to the physical cores, with 95 % intervals: Amdahl X = λN/(1 + σ(N − 1)), "
      "USL X = λN/(1 + σ(N − 1) + κN(N − 1))";
  for (const FactorText& f : factors) table.columns.push_back({f.name, f.number});
  for (const char* title : {"speedup", "Karp–Flatt", "Amdahl σ", "USL σ", "USL κ", "USL peak"})
    table.columns.push_back({title});
  table.columns.push_back({"laws", false});
  for (const ScalingGroup& group : scaling_groups(rows)) {
    for (const CellRow* row : group.rows) {
      std::vector<std::string> cells;
      for (const FactorText& f : factors) cells.push_back(f.text(row->cell));
      cells.push_back(with_interval(row->speedup));
      cells.push_back(percent(serial_share(*row)));
      if (row == group.rows.front()) {
        for (std::string& cell : law_cells(group.laws)) cells.push_back(std::move(cell));
      }
      cells.resize(table.columns.size());
      table.rows.push_back(std::move(cells));
    }
  }
  return table;
}

Table scaling_laws_data(const std::vector<CellRow>& rows) {
  Table table;
  for (const FactorText& f : factor_texts()) table.columns.push_back({f.name, f.number});
  for (const char* title : {"karp_flatt", "karp_flatt_low", "karp_flatt_high", "fitted_thread_counts",
                            "amdahl_fps_of_one", "amdahl_sigma", "amdahl_sigma_low", "amdahl_sigma_high",
                            "usl_fps_of_one", "usl_sigma", "usl_sigma_low", "usl_sigma_high", "usl_kappa",
                            "usl_kappa_low", "usl_kappa_high", "usl_peak_threads", "usl_peak_extrapolated"})
    table.columns.push_back({title});
  table.columns.push_back({"laws", false});
  for (const ScalingGroup& group : scaling_groups(rows)) {
    for (const CellRow* row : group.rows) {
      std::vector<std::string> cells;
      for (const FactorText& f : factor_texts()) cells.push_back(f.text(row->cell));
      for (std::string& number : unrounded(serial_share(*row))) cells.push_back(std::move(number));
      for (std::string& cell : law_data(group.laws)) cells.push_back(std::move(cell));
      table.rows.push_back(std::move(cells));
    }
  }
  return table;
}

}  // namespace raysweep
