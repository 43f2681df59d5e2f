#include "experiments/launcher.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>

#include "experiments/child.h"
#include "experiments/clock.h"
#include "experiments/interrupt.h"

namespace raysweep {

namespace {

std::vector<std::string> command(const Cell& cell, std::vector<std::string> options) {
  options.insert(options.begin(), {"launch", "--cell", to_json(cell).dump()});
  return options;
}

LaunchOutcome ended(Child& child, double deadline) {
  if (interrupted()) return {std::nullopt, {}, true};
  if (now_seconds() >= deadline)
    return {std::nullopt, "killed: it took longer than a launch may (measure.timeout)", false};
  return {std::nullopt, child.how_it_ended(), false};
}

LaunchOutcome outcome_of(Child& child, double deadline) {
  const auto line = child.read_line(deadline);
  if (!line) return ended(child, deadline);
  try {
    return {record_from_json(nlohmann::json::parse(*line)), {}, false};
  } catch (const std::exception& error) {
    return {std::nullopt, fmt::format("its record cannot be read: {}", error.what()), false};
  }
}

/// One record for all copies: the first one's, with everybody's frames.
LaunchOutcome corun(const Cell& cell, double seconds, double deadline) {
  Cell copy = cell;
  copy.processes = 1;
  std::vector<std::unique_ptr<Child>> children;
  for (int i = 0; i < cell.processes; ++i) {
    children.push_back(
        std::make_unique<Child>(command(copy, {"--seconds", fmt::format("{}", seconds), "--together"})));
  }
  for (auto& child : children) {
    if (!child->read_line(deadline)) return ended(*child, deadline);  // "ready"
  }
  for (auto& child : children) child->write_line("go");
  LaunchOutcome all;
  for (auto& child : children) {
    LaunchOutcome one = outcome_of(*child, deadline);
    if (!one.record) return one;
    if (!one.record->valid) return {std::nullopt, one.record->reason, false};
    if (!all.record) {
      all = std::move(one);
    } else if (one.record->image_hash != all.record->image_hash) {
      return {std::nullopt, "co-running copies rendered different pictures", false};
    } else {
      all.record->frame_seconds.push_back(one.record->frame_seconds.front());
    }
  }
  all.record->processes = cell.processes;
  // The others of one copy are the other copies, too; they all ran while it was timed.
  if (auto& others = all.record->state.other_processors)
    others = std::max(0.0, *others - (cell.processes - 1));
  all.record->cell = cell.key();
  return all;
}

}  // namespace

LaunchOutcome ProcessLauncher::launch(const Cell& cell, double seconds, double timeout_seconds) {
  const double deadline = now_seconds() + timeout_seconds;
  if (cell.processes > 1) return corun(cell, seconds, deadline);
  Child child(command(cell, {"--seconds", fmt::format("{}", seconds)}));
  return outcome_of(child, deadline);
}

LaunchOutcome ProcessLauncher::picture(const Cell& cell, double timeout_seconds) {
  Child child(command(cell, {"--picture"}));
  return outcome_of(child, now_seconds() + timeout_seconds);
}

}  // namespace raysweep
