#include "results/kernel_record.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "results/record_lines.h"
#include "results/variant_json.h"

namespace raysweep {

namespace {

/// Fields of every kernel, named once for both directions.
template <class Each>
void for_each_common_field(Each&& each) {
  using R = KernelRecord;
  each("schema", &R::schema), each("kind", &R::kind), each("experiment", &R::experiment);
  each("cell", &R::cell), each("launch", &R::launch), each("round", &R::round), each("seed", &R::seed);
  each("valid", &R::valid), each("reason", &R::reason), each("kernel", &R::kernel);
  each("compiler", &R::compiler), each("isa", &R::isa), each("threads", &R::threads);
  each("tests", &R::tests), each("iterations", &R::iterations), each("seconds", &R::seconds);
}

/// Those of intersection, but for the parameter, which may be NaN.
template <class Each>
void for_each_intersection_field(Each&& each) {
  using R = KernelRecord;
  each("method", &R::method), each("change", &R::change), each("variant", &R::variant);
  each("precision", &R::precision), each("rays_at_once", &R::rays_at_once);
  each("triangles_at_once", &R::triangles_at_once), each("layout", &R::layout);
  each("contraction", &R::contraction), each("bytes", &R::bytes), each("protocol", &R::protocol);
  each("scene", &R::scene), each("hit_rate", &R::hit_rate);
}

void add_ticks(nlohmann::json& json, const KernelRecord& record) {
  if (!record.ticks) return;
  const TickRecord& t = *record.ticks;
  json["ticks"] = {{"min", t.min}, {"avg", t.avg}, {"max", t.max}, {"sum", t.sum}};
}

/// The schema, which can be read.
int expect_schema(const nlohmann::json& json) {
  const int schema = json.at("schema").get<int>();
  const bool is_older = schema >= oldest_kernel_schema && schema < kernel_schema;
  expect_record(json, "kernel", is_older ? schema : kernel_schema);
  return schema;
}

}  // namespace

nlohmann::json to_json(const KernelRecord& record) {
  nlohmann::json json;
  const auto write = [&](const char* name, auto field) { json[name] = record.*field; };
  for_each_common_field(write);
  if (record.is_intersection()) {
    for_each_intersection_field(write);
    json["scheduler"] = record.scheduler;
    json["parameter"] = std::isnan(record.parameter) ? nlohmann::json() : nlohmann::json(record.parameter);
  } else {
    json["variant"] = record.factors;
  }
  json["clock"] = record.clock;
  add_ticks(json, record);
  return json;
}

std::string to_line(const KernelRecord& record) { return record_line(to_json(record)); }

KernelRecord kernel_record_from_json(const nlohmann::json& json) {
  // Schema 1 is what 2 is of intersection; neither has what 3 adds.
  const bool has_all = expect_schema(json) == kernel_schema;
  KernelRecord record;
  const auto read = [&](const char* name, auto field) { json.at(name).get_to(record.*field); };
  for_each_common_field(read);
  if (record.is_intersection()) {
    for_each_intersection_field(read);
    if (has_all) json.at("scheduler").get_to(record.scheduler);
    if (const auto& parameter = json.at("parameter"); !parameter.is_null())
      parameter.get_to(record.parameter);
  } else {
    json.at("variant").get_to(record.factors);
  }
  if (has_all) json.at("clock").get_to(record.clock);
  if (const auto ticks = json.find("ticks"); ticks != json.end())
    record.ticks = {ticks->at("min"), ticks->at("avg"), ticks->at("max"), ticks->at("sum")};
  return record;
}

std::vector<KernelRecord> read_kernel_records(const std::filesystem::path& file) {
  std::vector<KernelRecord> records;
  for_each_record_line(file,
                       [&](const nlohmann::json& line) { records.push_back(kernel_record_from_json(line)); });
  return records;
}

}  // namespace raysweep
