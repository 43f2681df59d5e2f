#include "experiments/cell.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "experiments/cell_factors.h"
#include "schedulers/registry.h"

namespace raysweep {

std::string Cell::chunk_text() const {
  const SchedulerInfo* const info = find_scheduler(scheduler);
  return info && !info->uses_chunk ? "-" : chunk.text();
}

std::string Cell::lights_text() const { return lights ? std::to_string(*lights) : "scene"; }

std::string Cell::picture_key() const {
  const RenderSettings& s = settings;
  return fmt::format(
      "scene={},mode={},width={},height={},subpixels={},pattern={},depth={},lights={},core={},method={},"
      "precision={},pixel_tolerance={},branches={}",
      scene, mode, s.width, s.height, s.subpixels, s.pattern, s.depth, lights_text(), s.core, s.method,
      s.precision, s.pixel_tolerance, s.branches);
}

std::string Cell::key() const {
  return fmt::format("{},accel={},leaf={},scheduler={},threads={},item={},chunk={},pin={}{}", picture_key(),
                     settings.accel, settings.leaf, scheduler, threads, item, chunk_text(), pin,
                     processes > 1 ? fmt::format(",processes={}", processes) : "");
}

void resolve_lights(Cell& cell) {
  if (!cell.lights) cell.lights = own_light_count(cell.scene);
}

void collapse_ignored_factors(Cell& cell) {
  const SchedulerInfo* const info = find_scheduler(cell.scheduler);
  if (!info) return;
  if (!info->uses_threads) cell.threads = 1;
  if (!info->uses_chunk) cell.chunk = {};
}

nlohmann::json to_json(const Cell& cell) {
  nlohmann::json json{{"mode", cell.mode}, {"processes", cell.processes}};
  for (const CellFactor& factor : cell_factors()) json[std::string(factor.name)] = factor.text(cell);
  return json;
}

Cell cell_from_json(const nlohmann::json& json) {
  Cell cell;
  cell.mode = json.at("mode").get<std::string>();
  cell.processes = json.at("processes").get<int>();
  for (const CellFactor& factor : cell_factors()) {
    set_factor(cell, factor, json.at(std::string(factor.name)).get<std::string>());
  }
  return cell;
}

}  // namespace raysweep
