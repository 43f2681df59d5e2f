#include "results/run_data.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "results/plan_file.h"

namespace raysweep {

RunData read_run(const std::filesystem::path& folder) {
  const nlohmann::json plan = read_plan_file(folder);
  if (const std::string kind = plan.value("kind", "picture"); kind != "picture")
    throw RecordError(
        fmt::format("{}: a run of kind \"{}\", where one of pictures is needed", folder.string(), kind));
  try {
    std::vector<Record> planned;
    for (const auto& cell : plan.at("cells")) planned.push_back(record_from_json(cell));
    RunData run;
    run.records = read_records(folder / "records.jsonl");
    run.context = {plan.at("experiment").get<std::string>(), plan.at("title").get<std::string>(),
                   noise_floor(run.records), detection_power(run.records)};
    run.rows = summarise(run.records, planned, plan.at("interval").get<double>());
    return run;
  } catch (const nlohmann::json::exception& error) {
    throw not_a_plan(folder, error.what());
  }
}

}  // namespace raysweep
