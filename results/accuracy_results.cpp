#include "results/accuracy_results.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "results/plan_file.h"

namespace raysweep {

namespace {

template <class Value>
void add_once(std::vector<Value>& list, const Value& value) {
  if (std::find(list.begin(), list.end(), value) == list.end()) list.push_back(value);
}

}  // namespace

Failures false_misses(const AccuracyRecord& r) { return {r.false_misses, r.hits}; }
Failures false_hits(const AccuracyRecord& r) { return {r.false_hits, r.trials - r.hits - r.boundary}; }
Failures missed_rays(const AccuracyRecord& r) { return {r.missed_rays, r.mesh_rays - r.uncovered}; }

bool has_failed(const AccuracyRecord& r) {
  return r.false_misses + r.false_hits + r.missed_rays + r.nonfinite > 0;
}

AccuracyResults::AccuracyResults(std::vector<AccuracyRecord> records) : records_(std::move(records)) {
  for (size_t i = 0; i < records_.size(); ++i) {
    const AccuracyRecord& r = records_[i];
    index_.emplace(Key{r.method, r.change, r.precision, r.case_id, r.level}, i);
    add_once(methods_, r.method);
    add_once(cases_, r.case_id);
    add_once(precisions_, r.precision);
    add_once(levels_[r.case_id], r.level);
  }
  for (auto& [id, levels] : levels_) std::sort(levels.begin(), levels.end());
}

const AccuracyRecord* AccuracyResults::find(const std::string& method, const std::string& change,
                                            const std::string& precision, const std::string& case_id,
                                            int level) const {
  const auto found = index_.find({method, change, precision, case_id, level});
  return found == index_.end() ? nullptr : &records_[found->second];
}

std::vector<int> AccuracyResults::levels(const std::string& case_id) const {
  const auto found = levels_.find(case_id);
  return found == levels_.end() ? std::vector<int>() : found->second;
}

std::string run_kind(const std::filesystem::path& folder) {
  return read_plan_file(folder).value("kind", "picture");
}

AccuracyData read_accuracy_run(const std::filesystem::path& folder) {
  const nlohmann::json plan = read_plan_file(folder);
  try {
    std::vector<LeftOutVariant> left_out;
    for (const auto& one : plan.at("left_out"))
      left_out.push_back({one.at("method"), one.at("change"), one.at("precision"), one.at("reason")});
    return {plan.at("experiment"), plan.at("title"), plan.at("trials"), std::move(left_out),
            AccuracyResults(read_accuracy_records(folder / "records.jsonl"))};
  } catch (const nlohmann::json::exception& error) {
    throw not_a_plan(folder, error.what());
  }
}

}  // namespace raysweep
