#include "results/plan_file.h"

#include <fmt/format.h>

#include <fstream>
#include <nlohmann/json.hpp>

namespace raysweep {

nlohmann::json read_plan_file(const std::filesystem::path& folder) {
  const std::filesystem::path file = folder / "plan.json";
  std::ifstream in(file, std::ios::binary);
  if (!in)
    throw RecordError(fmt::format("{}: no run is here: {} cannot be opened", folder.string(), file.string()));
  try {
    auto plan = nlohmann::json::parse(in);
    if (!plan.is_object()) throw not_a_plan(folder, "no object");
    return plan;
  } catch (const nlohmann::json::exception& error) {
    throw not_a_plan(folder, error.what());
  }
}

RecordError not_a_plan(const std::filesystem::path& folder, const std::string& reason) {
  return RecordError(fmt::format("{}: not a plan: {}", (folder / "plan.json").string(), reason));
}

}  // namespace raysweep
