#include "experiments/worker_report.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

namespace raysweep {

namespace {

double seconds(std::chrono::nanoseconds t) { return std::chrono::duration<double>(t).count(); }

}  // namespace

Table worker_table(const WorkerLog& log) {
  Table table;
  for (const char* title :
       {"worker", "items", "chunks", "busy ms", "in scheduler ms", "idle ms", "migrations"})
    table.columns.push_back({title});
  table.columns.push_back({"processors", false});
  const auto runs = static_cast<double>(log.runs().size());
  const auto a_run = [&](std::chrono::nanoseconds t) {
    return fmt::format("{:.3f}", seconds(t) * 1e3 / runs);
  };
  for (size_t worker = 0; worker < log.entries().size(); ++worker) {
    const WorkerEntry& e = log.entries()[worker];
    table.rows.push_back({std::to_string(worker), std::to_string(e.items), std::to_string(e.chunks),
                          a_run(e.busy), a_run(e.scheduling), a_run(e.idle), std::to_string(e.migrations),
                          fmt::format("{}", fmt::join(e.processors, ", "))});
  }
  return table;
}

nlohmann::json workers_as_json(const WorkerLog& log) {
  auto json = nlohmann::json::array();
  for (const WorkerEntry& e : log.entries()) {
    json.push_back({{"items", e.items},
                    {"chunks", e.chunks},
                    {"busy_seconds", seconds(e.busy)},
                    {"scheduling_seconds", seconds(e.scheduling)},
                    {"idle_seconds", seconds(e.idle)},
                    {"migrations", e.migrations},
                    {"processors", e.processors}});
  }
  return json;
}

}  // namespace raysweep
