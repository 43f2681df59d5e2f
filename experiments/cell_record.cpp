#include "experiments/cell_record.h"

#include "experiments/item.h"

namespace raysweep {

Record record_of(const Cell& cell) {
  Record r;
  r.cell = cell.key();
  r.scene = cell.scene;
  r.mode = cell.mode;
  r.width = cell.settings.width;
  r.height = cell.settings.height;
  r.subpixels = cell.settings.subpixels;
  r.pattern = cell.settings.pattern;
  r.depth = cell.settings.depth;
  r.pixel_tolerance = cell.settings.pixel_tolerance;
  r.branches = cell.settings.branches;
  r.lights = cell.lights.value_or(0);
  r.accel = cell.settings.accel;
  r.leaf = cell.settings.leaf;
  r.core = cell.settings.core;
  r.isa = cell.isa_text();
  r.method = cell.settings.method;
  r.precision = cell.settings.precision;
  r.scheduler = cell.scheduler;
  r.item = cell.item;
  r.threads = cell.threads;
  r.processes = cell.processes;
  r.twin = cell.twin;
  r.slowdown = cell.slowdown;
  r.chunk = cell.chunk_text();
  r.runtime = cell.runtime_text();
  r.order = cell.order;
  r.shares_cache_lines = shares_cache_lines(parse_item(cell.item).value(), cell.settings.width);
  r.pin = cell.pin_text();
  r.wait_policy = cell.wait_policy_text();
  r.spin_count = cell.spin_count_text();
  r.environment = cell.environment_text();
  return r;
}

}  // namespace raysweep
