#include "experiments/accuracy_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>

#include "experiments/clock.h"
#include "experiments/errors.h"
#include "experiments/in_order.h"
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

std::string name_of(const AccuracyBatch& batch) {
  return fmt::format("{} at {}, {}", batch.one->id, batch.one->difficulties[batch.level],
                     name_of(batch.precision));
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
  std::vector<AccuracyBatch> batches;
  for (const AccuracyBatch& batch : plan.batches) {
    AccuracyBatch rest = missing_of(batch, finished);
    if (!rest.subjects.empty()) batches.push_back(std::move(rest));
  }
  const int total = static_cast<int>(plan.cell_count() - finished.size());
  Progress progress("cells", now_seconds(), std::numeric_limits<double>::infinity(), quiet);
  const auto show = [&](size_t next) {
    if (next < batches.size())
      progress.show(static_cast<int>(report.cells - finished.size()), total, now_seconds(),
                    name_of(batches[next]));
  };
  std::atomic<bool> failed = false;
  const auto compute = [&](size_t i) {
    return run_batch(batches[i], plan.settings, [&] { return interrupted() || failed; });
  };
  const auto keep = [&](size_t i, const std::vector<AccuracyRecord>& records) {
    if (!records.empty()) experiment.files->append_text(to_lines(records), "cells");
    report.cells += records.size();
    report.was_interrupted = records.size() < batches[i].subjects.size();
    show(i + 1);
    return !report.was_interrupted;
  };
  show(0);
  try {
    work_in_order(batches.size(), plan.threads, compute,
                  [&](size_t i, const std::vector<AccuracyRecord>& records) {
                    try {
                      return keep(i, records);
                    } catch (const WorkError&) {
                      failed = true;
                      throw;
                    }
                  });
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
    work_in_order((plan.batches.size() + 3) / 4, plan.threads,
                  [&](size_t i) { return run_batch(plan.batches[4 * i], settings, interrupted); },
                  [](size_t, const std::vector<AccuracyRecord>&) { return true; });
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
  std::string text =
      fmt::format("{}: {}\n{} cells of {} rays each; seed {}; threads: {}\n", plan.settings.experiment,
                  plan.title, plan.cell_count(), plan.settings.ray_count, plan.settings.seed, plan.threads);
  for (const AccuracyBatch& batch : plan.batches) {
    for (const size_t subject : batch.subjects) text += cell_key(batch, subject) + "\n";
  }
  for (const Inapplicable& one : plan.left_out)
    text += fmt::format("left out: {} {} {}: {}\n", one.method, one.change, one.precision, one.reason);
  return text;
}

}  // namespace raysweep
