#include "results/record.h"

#include <fmt/format.h>

#include <map>
#include <nlohmann/json.hpp>
#include <numeric>

#include "results/record_lines.h"

template <>
struct nlohmann::adl_serializer<std::optional<double>> {
  static void to_json(json& json, const std::optional<double>& value) {
    json = value ? nlohmann::json(*value) : nlohmann::json();
  }
  static void from_json(const json& json, std::optional<double>& value) {
    value = json.is_null() ? std::nullopt : std::optional(json.get<double>());
  }
};

namespace raysweep {

// Workers of schemas 1 and 2 have no times, machines of schemas 1 to 3 no quota.
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE_WITH_DEFAULT(WorkerRecord, items, chunks, busy_seconds, scheduling_seconds,
                                                idle_seconds, cpu, migrations)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(ItemSeconds, sum, max)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(RayRecord, primary, shadow, reflected, refracted)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(LeftOutRecord, by_depth, by_tolerance, by_branches, bound, lost_media)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE_WITH_DEFAULT(MachineRecord, host, cpu, pus, cores, load, quota)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(LaunchState, wall_seconds, other_processors, steal_share, pressure_share,
                                   throttled_seconds, thermal_throttles, voluntary_switches,
                                   involuntary_switches, major_faults, spin_before_seconds,
                                   spin_after_seconds)

namespace {

/// `frame_seconds` is a plain list for one process and a list of lists for several.
nlohmann::json frames_to_json(const Record& record) {
  if (record.processes == 1 && record.frame_seconds.size() == 1) return record.frame_seconds.front();
  return record.frame_seconds;
}

std::vector<std::vector<double>> frames_from_json(const nlohmann::json& json) {
  if (!json.empty() && json.front().is_number()) return {json.get<std::vector<double>>()};
  return json.get<std::vector<std::vector<double>>>();
}

/// Every field but frame_seconds, named once for both directions.
template <class Each>
void for_each_field(Each&& each) {
#define RAYSWEEP_FIELD(name) each(#name, &Record::name)
  RAYSWEEP_FIELD(schema), RAYSWEEP_FIELD(kind), RAYSWEEP_FIELD(experiment), RAYSWEEP_FIELD(cell);
  RAYSWEEP_FIELD(launch), RAYSWEEP_FIELD(round), RAYSWEEP_FIELD(seed), RAYSWEEP_FIELD(valid),
      RAYSWEEP_FIELD(reason);
  RAYSWEEP_FIELD(machine), RAYSWEEP_FIELD(scene), RAYSWEEP_FIELD(mode), RAYSWEEP_FIELD(width),
      RAYSWEEP_FIELD(height);
  RAYSWEEP_FIELD(subpixels), RAYSWEEP_FIELD(pattern), RAYSWEEP_FIELD(depth), RAYSWEEP_FIELD(lights);
  RAYSWEEP_FIELD(accel), RAYSWEEP_FIELD(leaf), RAYSWEEP_FIELD(core), RAYSWEEP_FIELD(isa),
      RAYSWEEP_FIELD(method);
  RAYSWEEP_FIELD(precision), RAYSWEEP_FIELD(scheduler), RAYSWEEP_FIELD(runtime), RAYSWEEP_FIELD(item);
  RAYSWEEP_FIELD(threads), RAYSWEEP_FIELD(threads_seen), RAYSWEEP_FIELD(chunk), RAYSWEEP_FIELD(chunks_made);
  RAYSWEEP_FIELD(pin), RAYSWEEP_FIELD(processes);
  RAYSWEEP_FIELD(warmup_seconds), RAYSWEEP_FIELD(build_seconds), RAYSWEEP_FIELD(rays);
  RAYSWEEP_FIELD(image_hash), RAYSWEEP_FIELD(workers);
  RAYSWEEP_FIELD(pixel_tolerance), RAYSWEEP_FIELD(branches), RAYSWEEP_FIELD(left_out);
  RAYSWEEP_FIELD(order), RAYSWEEP_FIELD(wait_policy), RAYSWEEP_FIELD(spin_count), RAYSWEEP_FIELD(environment);
  RAYSWEEP_FIELD(library), RAYSWEEP_FIELD(cores_seen), RAYSWEEP_FIELD(processors_seen);
  RAYSWEEP_FIELD(chunk_sizes), RAYSWEEP_FIELD(item_seconds), RAYSWEEP_FIELD(empty_region_seconds);
  RAYSWEEP_FIELD(log_share), RAYSWEEP_FIELD(imbalance), RAYSWEEP_FIELD(shares_cache_lines);
  RAYSWEEP_FIELD(state), RAYSWEEP_FIELD(launch_seconds), RAYSWEEP_FIELD(warm), RAYSWEEP_FIELD(twin);
  RAYSWEEP_FIELD(slowdown), RAYSWEEP_FIELD(scene_hash), RAYSWEEP_FIELD(config_hash);
#undef RAYSWEEP_FIELD
}

int first_schema_of(const std::string& field) {
  static const std::map<std::string, int> later{{"pixel_tolerance", 2},
                                                {"branches", 2},
                                                {"left_out", 2},
                                                {"order", 3},
                                                {"wait_policy", 3},
                                                {"spin_count", 3},
                                                {"environment", 3},
                                                {"library", 3},
                                                {"cores_seen", 3},
                                                {"chunk_sizes", 3},
                                                {"item_seconds", 3},
                                                {"empty_region_seconds", 3},
                                                {"log_share", 3},
                                                {"imbalance", 3},
                                                {"shares_cache_lines", 3},
                                                {"processors_seen", 3},
                                                {"state", 4},
                                                {"launch_seconds", 4},
                                                {"warm", 4},
                                                {"twin", 4},
                                                {"slowdown", 4},
                                                {"scene_hash", 4},
                                                {"config_hash", 4}};
  const auto found = later.find(field);
  return found == later.end() ? 1 : found->second;
}

/// Before schema 3 `runtime` told the library, there was one OpenMP runtime to choose, and the serial
/// scheduler had a pin.
void take_over_runtime(Record& record) {
  if (record.scheduler == "serial") {
    for (std::string* unused : {&record.pin, &record.wait_policy, &record.spin_count, &record.environment})
      unused->assign(1, '-');
  }
  record.library = record.runtime;
  record.runtime = !record.scheduler.starts_with("omp_")                 ? "-"
                   : record.library.find("libgomp") != std::string::npos ? "libgomp"
                                                                         : "libomp";
}

}  // namespace

double Record::fps() const {
  double sum = 0;
  for (const auto& frames : frame_seconds) {
    sum += static_cast<double>(frames.size()) / std::accumulate(frames.begin(), frames.end(), 0.0);
  }
  return sum;
}

nlohmann::json to_json(const Record& record) {
  nlohmann::json json;
  for_each_field([&](const char* name, auto field) { json[name] = record.*field; });
  json["frame_seconds"] = frames_to_json(record);
  return json;
}

nlohmann::json state_as_json(const LaunchState& state) { return state; }

std::string to_line(const Record& record) {
  return to_json(record).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

Record record_from_json(const nlohmann::json& json) {
  const int schema = json.at("schema").get<int>();
  if (schema < oldest_record_schema || schema > record_schema) {
    throw RecordError(fmt::format("schema {} is unknown here; this version reads schemas {} to {}", schema,
                                  oldest_record_schema, record_schema));
  }
  Record record;
  for_each_field([&](const char* name, auto field) {
    if (schema < first_schema_of(name)) return;
    json.at(name).get_to(record.*field);
  });
  if (schema < 3) take_over_runtime(record);
  record.frame_seconds = frames_from_json(json.at("frame_seconds"));
  return record;
}

std::vector<Record> read_records(const std::filesystem::path& file) {
  std::vector<Record> records;
  for_each_record_line(file, [&](const nlohmann::json& line) { records.push_back(record_from_json(line)); });
  return records;
}

}  // namespace raysweep
