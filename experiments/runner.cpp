#include "experiments/runner.h"

#include <fmt/format.h>

#include <set>

#include "experiments/cell_record.h"
#include "experiments/errors.h"
#include "experiments/progress.h"

namespace raysweep {

namespace {

class Runner {
 public:
  Runner(const Config& config, const Plan& plan, const Machine& machine, RunFolder& folder,
         const RunnerTools& tools)
      : config_(config), plan_(plan), machine_(machine), folder_(folder), tools_(tools), start_(tools.now()) {
    for (const Record& r : folder.records()) {
      if (r.valid) done_.insert({r.cell, r.round});  // void ones are tried again
    }
    report_.launches = static_cast<int>(folder.records().size());
  }

  RunReport run() {
    const int total = plan_.rounds * static_cast<int>(plan_.cells.size());
    Progress progress(total - static_cast<int>(done_.size()), "launches", start_,
                      config_.measure.budget_seconds, tools_.quiet);
    const int before = report_.launches;
    for (int round = 0; round < plan_.rounds; ++round) {
      for (const size_t index : plan_.order(round)) {
        const PlannedCell& planned = plan_.cells[index];
        if (done_.contains({planned.key, round})) continue;
        const double now = tools_.now();
        if (now - start_ >= config_.measure.budget_seconds) return ended(RunEnd::out_of_budget);
        progress.show(report_.launches - before, now, label(planned.cell));
        if (!take(planned, round)) return ended(RunEnd::interrupted);
      }
      report_.whole_rounds = round + 1;
    }
    return report_;
  }

 private:
  RunReport ended(RunEnd end) {
    report_.end = end;
    return report_;
  }

  static std::string label(const Cell& cell) {
    if (cell.processes > 1) return fmt::format("{} · {} × serial", cell.mode, cell.processes);
    return fmt::format("{} · {} · {} {}", cell.mode, cell.scheduler, cell.threads,
                       cell.threads == 1 ? "thread" : "threads");
  }

  /// The serial picture of `cell`, rendered once; null when interrupted.
  const Record* reference(const Cell& cell) {
    const std::string key = cell.picture_key();
    if (const auto known = references_.find(key); known != references_.end()) return &known->second;
    Cell serial = cell;
    serial.scheduler = "serial";
    serial.threads = serial.processes = 1;
    collapse_ignored_factors(serial);
    LaunchOutcome outcome = tools_.launcher.picture(serial);
    if (outcome.interrupted) return nullptr;
    if (!outcome.record) {
      throw WorkError(fmt::format("the serial picture cannot be rendered ({}): {}", key, outcome.failure));
    }
    return &references_.emplace(key, std::move(*outcome.record)).first->second;
  }

  /// Voids a record whose picture or rays are not the serial ones.
  static void verify(Record& record, const Record& serial) {
    if (!record.valid) return;
    if (record.image_hash != serial.image_hash) {
      record.reason =
          fmt::format("picture {} differs from the serial one, {}", record.image_hash, serial.image_hash);
    } else if (record.rays != serial.rays) {
      record.reason = "its rays are not those of the serial picture";
    }
    record.valid = record.reason.empty();
  }

  /// Stands for a launch that left no record.
  static Record void_record(const Cell& cell, const std::string& reason) {
    Record r = record_of(cell);
    r.valid = false;
    r.reason = reason;
    return r;
  }

  /// One launch, verified and written down. False when interrupted.
  bool take(const PlannedCell& planned, int round) {
    const Record* const serial = reference(planned.cell);
    if (!serial) return false;
    const MachineRecord machine = machine_record(machine_);
    LaunchOutcome outcome = tools_.launcher.launch(planned.cell, config_.measure.seconds);
    if (outcome.interrupted) return false;
    Record record = outcome.record ? std::move(*outcome.record) : void_record(planned.cell, outcome.failure);
    verify(record, *serial);
    record.experiment = config_.experiment;
    record.launch = report_.launches++;
    record.round = round;
    record.seed = plan_.seed;
    record.machine = machine;
    report_.void_launches += !record.valid;
    folder_.append(record);
    return true;
  }

  const Config& config_;
  const Plan& plan_;
  const Machine& machine_;
  RunFolder& folder_;
  const RunnerTools& tools_;
  const double start_;
  std::set<std::pair<std::string, int>> done_;
  std::map<std::string, Record> references_;
  RunReport report_;
};

}  // namespace

RunReport run_plan(const Config& config, const Plan& plan, const Machine& machine, RunFolder& folder,
                   const RunnerTools& tools) {
  return Runner(config, plan, machine, folder, tools).run();
}

}  // namespace raysweep
