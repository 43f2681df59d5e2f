#include "experiments/accuracy_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>

#include "experiments/clock.h"
#include "experiments/errors.h"
#include "experiments/interrupt.h"
#include "experiments/progress.h"

namespace raysweep {

namespace {

/// The cells that a folder has records of.
std::set<std::string> finished_cells(const RunFiles& files) {
  std::set<std::string> keys;
  if (!files.holds_records()) return keys;
  try {
    for (const AccuracyRecord& record : read_accuracy_records(files.records_file())) keys.insert(record.cell);
  } catch (const RecordError& error) {
    throw RequestError(error.what());
  }
  return keys;
}

/// What of the batch has no record yet.
AccuracyBatch missing_of(const AccuracyBatch& batch, const std::set<std::string>& finished) {
  AccuracyBatch rest = batch;
  std::erase_if(rest.subjects, [&](size_t subject) { return finished.contains(cell_key(batch, subject)); });
  return rest;
}

std::string to_lines(const std::vector<AccuracyRecord>& records) {
  std::string lines;
  for (const AccuracyRecord& record : records) lines += to_line(record) + "\n";
  return lines;
}

}  // namespace

AccuracyExperiment open_accuracy(const AccuracyConfig& config, const std::filesystem::path& folder,
                                 const Machine& machine, bool resume) {
  AccuracyExperiment experiment{make_plan(config), nullptr};
  const RunPapers papers{config.text, to_json(experiment.plan)};
  experiment.files = std::make_unique<RunFiles>(folder, papers, machine, resume);
  return experiment;
}

AccuracyReport run_accuracy(const AccuracyExperiment& experiment, bool quiet) {
  const AccuracyPlan& plan = experiment.plan;
  const std::set<std::string> finished = finished_cells(*experiment.files);
  AccuracyReport report;
  report.cells = finished.size();
  const int total = static_cast<int>(plan.cell_count() - finished.size());
  Progress progress("cells", now_seconds(), std::numeric_limits<double>::infinity(), quiet);
  try {
    for (const AccuracyBatch& batch : plan.batches) {
      const AccuracyBatch rest = missing_of(batch, finished);
      if (rest.subjects.empty()) continue;
      progress.show(static_cast<int>(report.cells - finished.size()), total, now_seconds(),
                    fmt::format("{} at {}, {}", rest.one->id, rest.one->difficulties[rest.level],
                                name_of(rest.precision)));
      const std::vector<AccuracyRecord> records = run_batch(rest, plan.settings, interrupted);
      if (!records.empty()) experiment.files->append_text(to_lines(records), "cells");
      report.cells += records.size();
      report.was_interrupted = records.size() < rest.subjects.size();
      if (report.was_interrupted) break;
    }
  } catch (const WorkError& error) {
    report.failure = error.what();
  }
  return report;
}

double estimate_seconds(const AccuracyPlan& plan) {
  constexpr size_t few = 64, many = 512;  // rays: of a whole star they take a second or two
  const auto time_of = [&](size_t ray_count) {
    AccuracySettings settings = plan.settings;
    settings.ray_count = ray_count;
    const double start = now_seconds();
    for (size_t i = 0; i < plan.batches.size(); i += 4)
      (void)run_batch(plan.batches[i], settings, interrupted);
    return 4 * (now_seconds() - start);
  };
  (void)time_of(few);  // what is made once
  // A mesh takes its time whatever the number of rays: two samples tell that apart.
  const double of_few = time_of(few), of_many = time_of(many);
  const double by_ray = std::max(0.0, of_many - of_few) / (many - few);
  const double rest = std::max(0.0, of_few - by_ray * few);
  return rest + by_ray * static_cast<double>(plan.settings.ray_count);
}

std::string plan_as_text(const AccuracyPlan& plan) {
  std::string text = fmt::format("{}: {}\n{} cells of {} rays each; seed {}\n", plan.settings.experiment,
                                 plan.title, plan.cell_count(), plan.settings.ray_count, plan.settings.seed);
  for (const AccuracyBatch& batch : plan.batches) {
    for (const size_t subject : batch.subjects) text += cell_key(batch, subject) + "\n";
  }
  for (const Inapplicable& one : plan.left_out)
    text += fmt::format("left out: {} {} {}: {}\n", one.method, one.change, one.precision, one.reason);
  return text;
}

}  // namespace raysweep
