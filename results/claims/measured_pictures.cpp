#include <algorithm>
#include <functional>

#include "results/claims/measured_cells.h"
#include "results/factors.h"
#include "results/rounds.h"

namespace raysweep {

namespace {

using OfLaunch = std::function<std::optional<double>(const Record&)>;
using OfPair = std::function<std::optional<double>(const Record&, const Record&)>;

double chunks_of_frame(const Record& r) {
  std::vector<double> made;
  for (const uint64_t count : r.chunks_made) made.push_back(static_cast<double>(count));
  return median(std::move(made));
}

double rays_of_frame(const Record& r) {
  return static_cast<double>(r.rays.primary + r.rays.shadow + r.rays.reflected + r.rays.refracted);
}

class PictureCells {
 public:
  explicit PictureCells(const RunData& run) : run_(run), launches_(run.records) {}

  [[nodiscard]] std::vector<MeasuredCell> cells() const {
    std::vector<MeasuredCell> list;
    for (const CellRow& row : run_.rows) list.push_back(cell_of(row));
    return list;
  }

 private:
  [[nodiscard]] MeasuredCell cell_of(const CellRow& row) const {
    const Record& r = row.cell;
    MeasuredCell cell{r.cell, {}, {}, row.notes, row.oversubscribed};
    for (const FactorText& factor : factor_texts()) cell.factors[factor.name] = factor.text(r);
    const Rounds& own = launches_.valid(own_key(r));
    // Without a launch, too: what was planned and not measured must be told from what is not there.
    cell.values["fps"] = each(own, [](const Record& one) { return std::optional(one.fps()); });
    cell.values["frame_seconds"] = each(own, [](const Record& one) { return std::optional(1 / one.fps()); });
    const auto add = [&](const char* name, Observation value) {
      if (value.value.count > 0) cell.values[name] = std::move(value);
    };
    const OfPair speedup = [](const Record& a, const Record& b) { return std::optional(a.fps() / b.fps()); };
    const Rounds& serial = launches_.valid(serial_key(r));
    add("speedup", each_pair(own, serial, speedup));
    add("speedup_one", each_pair(own, launches_.valid(one_thread_key(r)), speedup));
    add("quality", each_pair(own, serial, launch_quality));
    add("imbalance", each(own, launch_imbalance));
    add("chunks", each(own, [](const Record& one) {
          return one.chunks_made.empty() ? std::nullopt : std::optional(chunks_of_frame(one));
        }));
    add("empty_region_seconds", each(own, [](const Record& one) {
          return one.empty_region_seconds > 0 ? std::optional(one.empty_region_seconds) : std::nullopt;
        }));
    add("build_seconds", each(own, [](const Record& one) { return std::optional(one.build_seconds); }));
    if (!own.empty()) cell.values["rays"] = exact_observation(rays_of_frame(*own.begin()->second));
    return cell;
  }

  static Observation each(const Rounds& own, const OfLaunch& value) {
    std::map<int, double> by_round;
    for (const auto& [round, launch] : own) {
      if (const auto sample = value(*launch)) by_round[round] = *sample;
    }
    return observation_of(std::move(by_round));
  }

  static Observation each_pair(const Rounds& own, const Rounds& base, const OfPair& value) {
    std::map<int, double> by_round;
    for (const auto& [round, launch] : own) {
      const auto other = base.find(round);
      if (other == base.end()) continue;
      if (const auto sample = value(*launch, *other->second)) by_round[round] = *sample;
    }
    return observation_of(std::move(by_round));
  }

  const RunData& run_;
  Launches launches_;
};

}  // namespace

std::vector<MeasuredCell> measured_cells(const RunData& run) { return PictureCells(run).cells(); }

}  // namespace raysweep
