#include <fmt/format.h>

#include <cmath>

#include "results/claims/measured_cells.h"
#include "results/factors.h"

namespace raysweep {

namespace {

/// As configs write numbers.
std::string plain_number(double value) { return std::isnan(value) ? "none" : fmt::format("{:g}", value); }

/// Names, as they stand in records, for both directions of `factors_of`.
Factors factors_of(const VariantRecord& v) {
  return {{"division", v.division},   {"reciprocal", v.reciprocal}, {"order", v.order}, {"edges", v.edges},
          {"early_out", v.early_out}, {"output", v.output},         {"data", v.data}};
}

Factors factors_of(const KernelRecord& r) {
  if (!r.is_intersection() && !r.kernel.empty()) {
    Factors factors = r.factors;
    factors["kernel"] = r.kernel;
    return factors;
  }
  Factors factors = factors_of(r.variant);
  factors.insert({{"kernel", r.kernel},
                  {"method", r.method},
                  {"change", r.change},
                  {"precision", r.precision},
                  {"rays_at_once", std::to_string(r.rays_at_once)},
                  {"triangles_at_once", std::to_string(r.triangles_at_once)},
                  {"layout", r.layout},
                  {"contraction", r.contraction},
                  {"compiler", r.compiler},
                  {"isa", r.isa},
                  {"bytes", std::to_string(r.bytes)},
                  {"protocol", r.protocol},
                  {"parameter", plain_number(r.parameter)},
                  {"scene", r.scene.empty() ? "none" : r.scene},
                  {"threads", std::to_string(r.threads)},
                  {"scheduler", r.scheduler}});
  return factors;
}

Factors factors_of(const AccuracyRecord& r) {
  Factors factors = factors_of(r.variant);
  factors.insert({{"method", r.method},
                  {"change", r.change},
                  {"precision", r.precision},
                  {"case", r.case_id},
                  {"difficulty", plain_number(r.difficulty)}});
  return factors;
}

Factors factors_of(const PixelsRecord& r) {
  return {{"scene", r.scene},
          {"mode", r.mode},
          {"offset", plain_number(r.offset)},
          {"core", r.core},
          {"method", r.method},
          {"precision", r.precision},
          {"pattern", r.pattern},
          {"subpixels", std::to_string(r.subpixels)}};
}

std::vector<std::string> names_of(const Factors& factors) {
  std::vector<std::string> names;
  for (const auto& [name, value] : factors) names.push_back(name);
  return names;
}

/// Of a measure that may have no value.
void add_exact(MeasuredCell& cell, const char* name, double value) {
  if (!std::isnan(value)) cell.values[name] = exact_observation(value);
}

/// Nothing where there were no errors to tell of: they are NaN then.
void add_errors(MeasuredCell& cell, const std::string& name, const ErrorRecord& errors) {
  add_exact(cell, (name + "_p50").c_str(), errors.p50);
  add_exact(cell, (name + "_p99").c_str(), errors.p99);
  add_exact(cell, (name + "_max").c_str(), errors.max);
  add_exact(cell, (name + "_mean").c_str(), errors.mean);
}

/// Each statistic is a cell of its own, since it is a factor of claims and of what papers print.
void add_ticks(std::vector<MeasuredCell>& list, const KernelCellResult& result) {
  for (const auto& [statistic, by_round] : result.ticks) {
    MeasuredCell& cell =
        list.emplace_back(MeasuredCell{result.record.cell + '/' + statistic, factors_of(result.record), {}});
    cell.factors["statistic"] = statistic;
    cell.values["ticks"] = observation_of(by_round);
  }
}

}  // namespace

std::vector<MeasuredCell> measured_cells(const KernelData& run) {
  std::vector<MeasuredCell> list;
  for (const KernelCellResult& result : run.results.cells()) {
    MeasuredCell& cell = list.emplace_back(MeasuredCell{result.record.cell, factors_of(result.record), {}});
    cell.values["nanoseconds"] = observation_of(result.by_round);
    if (result.void_rounds > 0)
      cell.notes.push_back(fmt::format("{} rounds void: {}", result.void_rounds, result.reason));
    add_ticks(list, result);
  }
  return list;
}

std::vector<MeasuredCell> measured_cells(const AccuracyData& run) {
  std::vector<MeasuredCell> list;
  for (const AccuracyRecord& r : run.results.records()) {
    MeasuredCell& cell = list.emplace_back(MeasuredCell{r.cell, factors_of(r), {}});
    add_errors(cell, "t_error", r.t_error);
    add_errors(cell, "uv_error", r.uv_error);
    add_errors(cell, "weight_error", r.weight_error);
    add_exact(cell, "false_misses", static_cast<double>(r.false_misses));
    add_exact(cell, "false_hits", static_cast<double>(r.false_hits));
    add_exact(cell, "missed_rays", static_cast<double>(r.missed_rays));
    add_exact(cell, "extra", static_cast<double>(r.extra));
    add_exact(cell, "other_nearest", static_cast<double>(r.other_nearest));
    add_exact(cell, "nonfinite", static_cast<double>(r.nonfinite));
  }
  return list;
}

std::vector<MeasuredCell> measured_cells(const PixelsData& run) {
  std::vector<MeasuredCell> list;
  for (const PixelsRow& row : run.rows) {
    const PixelsRecord& r = row.first;
    MeasuredCell& cell = list.emplace_back(MeasuredCell{r.cell, factors_of(r), {}});
    cell.values["nanoseconds"] = observation_of(row.nanoseconds_by_round);
    add_exact(cell, "wrong_pixels", static_cast<double>(r.wrong_pixels));
    add_exact(cell, "flip_mean", r.flip_mean);
    add_exact(cell, "rmse", r.rmse);
    add_exact(cell, "edge_rmse", r.edge_rmse);
    if (row.void_rounds > 0) cell.notes.push_back(fmt::format("{} rounds void", row.void_rounds));
  }
  return list;
}

std::vector<std::string> quantities_of(const std::string& kind) {
  if (kind == "kernel") return {"nanoseconds", "ticks"};
  if (kind == "accuracy")
    return {"t_error_p99",      "t_error_p50",      "t_error_max",      "t_error_mean",
            "uv_error_p50",     "uv_error_p99",     "uv_error_max",     "uv_error_mean",
            "weight_error_p50", "weight_error_p99", "weight_error_max", "weight_error_mean",
            "false_misses",     "false_hits",       "missed_rays",      "extra",
            "other_nearest",    "nonfinite"};
  if (kind == "pixels") return {"wrong_pixels", "rmse", "edge_rmse", "flip_mean", "nanoseconds"};
  return {"fps",    "frame_seconds",        "speedup",       "speedup_one", "quality", "imbalance",
          "chunks", "empty_region_seconds", "build_seconds", "rays"};
}

std::vector<std::string> factors_of(const std::string& kind) {
  if (kind == "kernel") return names_of(factors_of(KernelRecord()));
  if (kind == "accuracy") return names_of(factors_of(AccuracyRecord()));
  if (kind == "pixels") return names_of(factors_of(PixelsRecord()));
  std::vector<std::string> names;
  for (const FactorText& factor : factor_texts()) names.push_back(factor.name);
  return names;
}

}  // namespace raysweep
