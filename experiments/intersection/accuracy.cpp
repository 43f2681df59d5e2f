#include "experiments/intersection/accuracy.h"

#include <fmt/format.h>

#include <numeric>

#include "experiments/intersection/run_subjects.h"
#include "experiments/intersection/tally.h"

namespace raysweep {

namespace {

VariantRecord variant_record(const Variant& variant) {
  const auto names = factor_names(variant);
  const auto value = [&](size_t i) { return std::string(names[i].value); };
  return {value(0), value(1), value(2), value(3), value(4), value(5), value(6)};
}

ErrorRecord error_record(const std::vector<double>& errors) {
  const ErrorSummary s = Tally::summary(errors);
  return {s.count, s.p50, s.p99, s.p999, s.greatest, s.mean};
}

void take_tally(AccuracyRecord& record, const Tally& tally) {
  record.rays = tally.rays;
  record.mesh_rays = tally.mesh_rays;
  record.trials = tally.trials;
  record.hits = tally.hits;
  record.boundary = tally.boundary;
  record.false_hits = tally.false_hits;
  record.false_misses = tally.false_misses;
  record.nonfinite = tally.nonfinite;
  record.missed_rays = tally.missed_rays;
  record.extra = tally.extra_rays;
  record.uncovered = tally.uncovered_rays;
  record.other_nearest = tally.other_nearest;
  record.t_error = error_record(tally.t_error);
  record.uv_error = error_record(tally.uv_error);
  record.weight_error = error_record(tally.weight_error);
  record.consistency = error_record(tally.difference);
  record.off_plane = error_record(tally.off_plane);
}

/// All but what the method did.
template <class T>
AccuracyRecord blank_record(const AccuracyBatch& batch, const AccuracySettings& settings, size_t subject) {
  const Subject<T>& s = run_subjects<T>()[subject];
  AccuracyRecord record;
  record.experiment = settings.experiment;
  record.seed = settings.seed;
  record.cell = cell_key(batch, subject);
  record.method = s.method;
  record.change = s.change;
  record.variant = variant_record(s.variant);
  record.precision = name_of(batch.precision);
  record.case_id = batch.one->id;
  record.difficulty_of = batch.one->difficulty;
  record.difficulty = batch.one->difficulties[batch.level];
  record.level = static_cast<int>(batch.level);
  return record;
}

template <class T>
std::vector<AccuracyRecord> records_of(const AccuracyBatch& batch, const AccuracySettings& settings,
                                       const std::function<bool()>& stops) {
  std::vector<AccuracyRecord> records;
  if (batch.subjects.empty() || stops()) return records;
  const JudgedTrials<T> judged(*batch.one, batch.one->difficulties[batch.level], settings.seed,
                               settings.ray_count);
  for (const size_t index : batch.subjects) {
    if (stops()) break;
    const Subject<T>& subject = run_subjects<T>()[index];
    AccuracyRecord record = blank_record<T>(batch, settings, index);
    take_tally(record, tally_of(judged, subject.find_hits(judged.trials), subject.variant.output));
    records.push_back(std::move(record));
  }
  return records;
}

}  // namespace

std::vector<AccuracyBatch> all_batches(const Case& one) {
  const auto indices = [](size_t count) {
    std::vector<size_t> all(count);
    std::iota(all.begin(), all.end(), size_t{0});
    return all;
  };
  std::vector<AccuracyBatch> batches;
  for (size_t level = 0; level < one.difficulties.size(); ++level) {
    batches.push_back({&one, level, Precision::float_precision, indices(all_subjects<float>().size())});
    batches.push_back({&one, level, Precision::double_precision, indices(all_subjects<double>().size())});
  }
  return batches;
}

std::string cell_key(const AccuracyBatch& batch, size_t subject) {
  const auto key = [&](const auto& s) {
    return fmt::format("{}/{}/{}/{}/{}", s.method, s.change, name_of(batch.precision), batch.one->id,
                       batch.one->difficulties[batch.level]);
  };
  return batch.precision == Precision::float_precision ? key(run_subjects<float>()[subject])
                                                       : key(run_subjects<double>()[subject]);
}

std::vector<AccuracyRecord> run_batch(const AccuracyBatch& batch, const AccuracySettings& settings,
                                      const std::function<bool()>& stops) {
  return batch.precision == Precision::float_precision ? records_of<float>(batch, settings, stops)
                                                       : records_of<double>(batch, settings, stops);
}

}  // namespace raysweep
