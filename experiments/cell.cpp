#include "experiments/cell.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "experiments/cell_factors.h"
#include "schedulers/registry.h"
#include "tracer/wide/isa.h"

namespace raysweep {

namespace {

/// The serial scheduler stands for a program without any of this.
bool uses_placement(const std::string& scheduler) {
  const SchedulerInfo* const info = find_scheduler(scheduler);
  return !info || info->uses_threads;
}

bool chooses_runtime(const std::string& scheduler) {
  const SchedulerInfo* const info = find_scheduler(scheduler);
  return info && info->uses_runtime();
}

}  // namespace

std::string Cell::chunk_text() const {
  const SchedulerInfo* const info = find_scheduler(scheduler);
  return info && !info->uses_chunk ? "-" : chunk.text();
}

std::string Cell::runtime_text() const {
  if (!chooses_runtime(scheduler)) return "-";
  return runtime == "default" ? default_runtime(*find_scheduler(scheduler)) : runtime;
}

std::string Cell::pin_text() const { return uses_placement(scheduler) ? pin : "-"; }

std::string Cell::wait_policy_text() const {
  const SchedulerInfo* const info = find_scheduler(scheduler);
  return info && !info->uses_wait_policy() ? "-" : wait_policy;
}

std::string Cell::spin_count_text() const {
  const SchedulerInfo* const info = find_scheduler(scheduler);
  if (info && !uses_spin_count(*info, runtime_text())) return "-";
  return spin_count ? std::to_string(*spin_count) : "default";
}

std::string Cell::environment_text() const {
  const SchedulerInfo* const info = find_scheduler(scheduler);
  return info && info->family == "std" ? "-" : environment;  // std::thread reads none of it
}

std::string Cell::isa_text() const {
  if (settings.core != "wide") return "baseline";
  return settings.isa == "best" ? std::string(best_isa()) : settings.isa;
}

std::string Cell::lights_text() const { return lights ? std::to_string(*lights) : "scene"; }

std::string Cell::picture_key() const {
  const RenderSettings& s = settings;
  return fmt::format(
      "scene={},mode={},width={},height={},subpixels={},pattern={},depth={},lights={},core={},method={},"
      "precision={},pixel_tolerance={},branches={}{}",
      scene, mode, s.width, s.height, s.subpixels, s.pattern, s.depth, lights_text(), s.core, s.method,
      s.precision, s.pixel_tolerance, s.branches, s.core == "wide" ? ",isa=" + isa_text() : "");
}

std::string Cell::key() const {
  return fmt::format(
      "{},accel={},leaf={},scheduler={},runtime={},threads={},item={},order={},chunk={},pin={},wait_policy={}"
      ",spin_count={},environment={}{}{}{}",
      picture_key(), settings.accel, settings.leaf, scheduler, runtime_text(), threads, item, order,
      chunk_text(), pin_text(), wait_policy_text(), spin_count_text(), environment_text(),
      slowdown > 0 ? fmt::format(",slowdown={}", slowdown) : "",
      processes > 1 ? fmt::format(",processes={}", processes) : "",
      twin > 0 ? fmt::format(",twin={}", twin) : "");
}

void resolve_lights(Cell& cell) {
  if (!cell.lights) cell.lights = own_light_count(cell.scene);
}

Cell serial_cell(const Cell& cell) {
  Cell serial = cell;
  serial.scheduler = "serial";
  serial.threads = serial.processes = 1;
  serial.twin = 0;
  serial.slowdown = 0;
  collapse_ignored_factors(serial);
  return serial;
}

void collapse_ignored_factors(Cell& cell) {
  const SchedulerInfo* const info = find_scheduler(cell.scheduler);
  if (!info) return;
  const Cell usual;
  const bool is_wide = cell.settings.core == "wide";
  cell.settings.isa = is_wide ? cell.isa_text() : usual.settings.isa;
  if (is_wide && cell.settings.accel == "sah")
    cell.settings.leaf = usual.settings.leaf;  // its leaves fill their blocks
  if (!info->uses_threads) cell.threads = 1;
  if (!info->uses_chunk) cell.chunk = usual.chunk;
  cell.runtime = info->uses_runtime() ? cell.runtime_text() : usual.runtime;
  if (info->family == "std") cell.environment = usual.environment;
  if (!uses_placement(cell.scheduler)) {
    cell.pin = usual.pin;
    if (cell.order == "lpt") cell.order = usual.order;  // what comes first matters to nobody who is alone
  }
  if (!info->uses_wait_policy()) cell.wait_policy = usual.wait_policy;
  if (!uses_spin_count(*info, cell.runtime)) cell.spin_count = usual.spin_count;
}

nlohmann::json to_json(const Cell& cell) {
  nlohmann::json json{{"mode", cell.mode}, {"processes", cell.processes}, {"twin", cell.twin}};
  for (const CellFactor& factor : cell_factors()) json[std::string(factor.name)] = factor.text(cell);
  return json;
}

Cell cell_from_json(const nlohmann::json& json) {
  Cell cell;
  cell.mode = json.at("mode").get<std::string>();
  cell.processes = json.at("processes").get<int>();
  cell.twin = json.at("twin").get<int>();
  for (const CellFactor& factor : cell_factors()) {
    set_factor(cell, factor, json.at(std::string(factor.name)).get<std::string>());
  }
  return cell;
}

}  // namespace raysweep
