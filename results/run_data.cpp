#include "results/run_data.h"

#include <fmt/format.h>

#include <fstream>
#include <nlohmann/json.hpp>

namespace raysweep {

RunData read_run(const std::filesystem::path& folder) {
  const std::filesystem::path plan_file = folder / "plan.json";
  std::ifstream in(plan_file, std::ios::binary);
  if (!in)
    throw RecordError(
        fmt::format("{}: no run is here: {} cannot be opened", folder.string(), plan_file.string()));
  try {
    const auto plan = nlohmann::json::parse(in);
    std::vector<Record> planned;
    for (const auto& cell : plan.at("cells")) planned.push_back(record_from_json(cell));
    RunData run;
    run.records = read_records(folder / "records.jsonl");
    run.context = {plan.at("experiment").get<std::string>(), plan.at("title").get<std::string>(),
                   noise_floor(run.records), detection_power(run.records)};
    run.rows = summarise(run.records, planned, plan.at("interval").get<double>());
    return run;
  } catch (const nlohmann::json::exception& error) {
    throw RecordError(fmt::format("{}: not a plan: {}", plan_file.string(), error.what()));
  }
}

}  // namespace raysweep
