#include "results/accuracy_record.h"

#include <limits>
#include <nlohmann/json.hpp>

#include "results/record_lines.h"
#include "results/variant_json.h"

namespace raysweep {

// NaN is written as null, and read back as what it was.
void to_json(nlohmann::json& json, const ErrorRecord& e) {
  json = {{"count", e.count}, {"p50", e.p50}, {"p99", e.p99},
          {"p999", e.p999},   {"max", e.max}, {"mean", e.mean}};
}
void from_json(const nlohmann::json& json, ErrorRecord& e) {
  const auto number = [&](const char* name) {
    const auto& value = json.at(name);
    return value.is_null() ? std::numeric_limits<double>::quiet_NaN() : value.get<double>();
  };
  e = {json.at("count").get<uint64_t>(),
       number("p50"),
       number("p99"),
       number("p999"),
       number("max"),
       number("mean")};
}

namespace {

/// Every field, named once for both directions.
template <class Each>
void for_each_accuracy_field(Each&& each) {
  using R = AccuracyRecord;
  each("schema", &R::schema), each("kind", &R::kind), each("experiment", &R::experiment);
  each("cell", &R::cell), each("launch", &R::launch), each("round", &R::round), each("seed", &R::seed);
  each("valid", &R::valid), each("reason", &R::reason);
  each("method", &R::method), each("change", &R::change);
  each("variant", &R::variant), each("precision", &R::precision), each("case", &R::case_id);
  each("difficulty_of", &R::difficulty_of), each("difficulty", &R::difficulty), each("level", &R::level);
  each("rays", &R::rays), each("mesh_rays", &R::mesh_rays), each("trials", &R::trials);
  each("hits", &R::hits), each("boundary", &R::boundary), each("false_hits", &R::false_hits);
  each("false_misses", &R::false_misses), each("nonfinite", &R::nonfinite);
  each("missed_rays", &R::missed_rays), each("extra", &R::extra), each("uncovered", &R::uncovered);
  each("other_nearest", &R::other_nearest);
  each("t_error", &R::t_error), each("uv_error", &R::uv_error), each("weight_error", &R::weight_error),
      each("consistency", &R::consistency);
  each("off_plane", &R::off_plane);
}

}  // namespace

nlohmann::json to_json(const AccuracyRecord& record) {
  nlohmann::json json;
  for_each_accuracy_field([&](const char* name, auto field) { json[name] = record.*field; });
  return json;
}

std::string to_line(const AccuracyRecord& record) { return record_line(to_json(record)); }

AccuracyRecord accuracy_record_from_json(const nlohmann::json& json) {
  expect_record(json, "accuracy", accuracy_schema);
  AccuracyRecord record;
  for_each_accuracy_field([&](const char* name, auto field) { json.at(name).get_to(record.*field); });
  return record;
}

std::vector<AccuracyRecord> read_accuracy_records(const std::filesystem::path& file) {
  std::vector<AccuracyRecord> records;
  for_each_record_line(
      file, [&](const nlohmann::json& line) { records.push_back(accuracy_record_from_json(line)); });
  return records;
}

}  // namespace raysweep
