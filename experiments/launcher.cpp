#include "experiments/launcher.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>

#include "experiments/child.h"
#include "experiments/interrupt.h"

namespace raysweep {

namespace {

std::vector<std::string> command(const Cell& cell, std::vector<std::string> options) {
  options.insert(options.begin(), {"launch", "--cell", to_json(cell).dump()});
  return options;
}

LaunchOutcome ended(Child& child) {
  if (interrupted()) return {std::nullopt, {}, true};
  return {std::nullopt, child.how_it_ended(), false};
}

LaunchOutcome outcome_of(Child& child) {
  const auto line = child.read_line();
  if (!line) return ended(child);
  try {
    return {record_from_json(nlohmann::json::parse(*line)), {}, false};
  } catch (const std::exception& error) {
    return {std::nullopt, fmt::format("its record cannot be read: {}", error.what()), false};
  }
}

/// One record for all copies: the first one's, with everybody's frames.
LaunchOutcome corun(const Cell& cell, double seconds) {
  Cell copy = cell;
  copy.processes = 1;
  std::vector<std::unique_ptr<Child>> children;
  for (int i = 0; i < cell.processes; ++i) {
    children.push_back(
        std::make_unique<Child>(command(copy, {"--seconds", fmt::format("{}", seconds), "--together"})));
  }
  for (auto& child : children) {
    if (!child->read_line()) return ended(*child);  // "ready"
  }
  for (auto& child : children) child->write_line("go");
  LaunchOutcome all;
  for (auto& child : children) {
    LaunchOutcome one = outcome_of(*child);
    if (!one.record) return one;
    if (!all.record) {
      all = std::move(one);
    } else if (one.record->image_hash != all.record->image_hash) {
      return {std::nullopt, "co-running copies rendered different pictures", false};
    } else {
      all.record->frame_seconds.push_back(one.record->frame_seconds.front());
    }
  }
  all.record->processes = cell.processes;
  all.record->cell = cell.key();
  return all;
}

}  // namespace

LaunchOutcome ProcessLauncher::launch(const Cell& cell, double seconds) {
  if (cell.processes > 1) return corun(cell, seconds);
  Child child(command(cell, {"--seconds", fmt::format("{}", seconds)}));
  return outcome_of(child);
}

LaunchOutcome ProcessLauncher::picture(const Cell& cell) {
  Child child(command(cell, {"--picture"}));
  return outcome_of(child);
}

}  // namespace raysweep
