#include "results/pixels_record.h"

#include <limits>
#include <nlohmann/json.hpp>

#include "results/record_lines.h"

namespace raysweep {

namespace {

/// Every field, named once for both directions.
template <class Each>
void for_each_pixels_field(Each&& each) {
  using R = PixelsRecord;
  each("schema", &R::schema), each("kind", &R::kind), each("experiment", &R::experiment);
  each("cell", &R::cell), each("launch", &R::launch), each("round", &R::round), each("seed", &R::seed);
  each("valid", &R::valid), each("reason", &R::reason), each("scene", &R::scene), each("offset", &R::offset);
  each("mode", &R::mode), each("width", &R::width), each("height", &R::height), each("core", &R::core);
  each("method", &R::method), each("precision", &R::precision), each("pattern", &R::pattern);
  each("subpixels", &R::subpixels), each("reference_subpixels", &R::reference_subpixels);
  each("pixels", &R::pixels);
  each("wrong_pixels", &R::wrong_pixels), each("hole_pixels", &R::hole_pixels);
  each("nonfinite_pixels", &R::nonfinite_pixels), each("flip_mean", &R::flip_mean);
  each("flip_p95", &R::flip_p95), each("flip_max", &R::flip_max);
  each("max_difference", &R::max_difference), each("rmse", &R::rmse), each("edge_pixels", &R::edge_pixels),
      each("edge_rmse", &R::edge_rmse), each("rays", &R::rays);
  each("seconds", &R::seconds);
}

}  // namespace

nlohmann::json to_json(const PixelsRecord& record) {
  nlohmann::json json;
  for_each_pixels_field([&](const char* name, auto field) { json[name] = record.*field; });
  return json;
}

std::string to_line(const PixelsRecord& record) { return record_line(to_json(record)); }

PixelsRecord pixels_record_from_json(const nlohmann::json& json) {
  expect_record(json, "pixels", pixels_schema);
  PixelsRecord record;
  // NaN was written as null.
  for_each_pixels_field([&](const char* name, auto field) {
    const auto& value = json.at(name);
    if constexpr (std::is_same_v<decltype(field), double PixelsRecord::*>) {
      record.*field =
          value.is_null() ? std::numeric_limits<double>::quiet_NaN() : value.template get<double>();
    } else {
      value.get_to(record.*field);
    }
  });
  return record;
}

std::vector<PixelsRecord> read_pixels_records(const std::filesystem::path& file) {
  std::vector<PixelsRecord> records;
  for_each_record_line(file,
                       [&](const nlohmann::json& line) { records.push_back(pixels_record_from_json(line)); });
  return records;
}

}  // namespace raysweep
