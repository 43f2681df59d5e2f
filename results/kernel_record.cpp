#include "results/kernel_record.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "results/record_lines.h"
#include "results/variant_json.h"

namespace raysweep {

namespace {

/// Every field but the parameter, which may be NaN, named once for both directions.
template <class Each>
void for_each_kernel_field(Each&& each) {
  using R = KernelRecord;
  each("schema", &R::schema), each("kind", &R::kind), each("experiment", &R::experiment);
  each("cell", &R::cell), each("launch", &R::launch), each("round", &R::round), each("seed", &R::seed);
  each("valid", &R::valid), each("reason", &R::reason), each("kernel", &R::kernel);
  each("method", &R::method), each("change", &R::change), each("variant", &R::variant);
  each("precision", &R::precision), each("rays_at_once", &R::rays_at_once);
  each("triangles_at_once", &R::triangles_at_once), each("layout", &R::layout);
  each("contraction", &R::contraction), each("compiler", &R::compiler), each("isa", &R::isa);
  each("bytes", &R::bytes), each("protocol", &R::protocol), each("scene", &R::scene);
  each("threads", &R::threads), each("hit_rate", &R::hit_rate), each("tests", &R::tests);
  each("iterations", &R::iterations), each("seconds", &R::seconds);
}

}  // namespace

nlohmann::json to_json(const KernelRecord& record) {
  nlohmann::json json;
  for_each_kernel_field([&](const char* name, auto field) { json[name] = record.*field; });
  json["parameter"] = std::isnan(record.parameter) ? nlohmann::json() : nlohmann::json(record.parameter);
  return json;
}

std::string to_line(const KernelRecord& record) { return record_line(to_json(record)); }

KernelRecord kernel_record_from_json(const nlohmann::json& json) {
  expect_record(json, "kernel", kernel_schema);
  KernelRecord record;
  for_each_kernel_field([&](const char* name, auto field) { json.at(name).get_to(record.*field); });
  if (const auto& parameter = json.at("parameter"); !parameter.is_null()) parameter.get_to(record.parameter);
  return record;
}

std::vector<KernelRecord> read_kernel_records(const std::filesystem::path& file) {
  std::vector<KernelRecord> records;
  for_each_record_line(file,
                       [&](const nlohmann::json& line) { records.push_back(kernel_record_from_json(line)); });
  return records;
}

}  // namespace raysweep
