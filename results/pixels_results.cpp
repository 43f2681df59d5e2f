#include "results/pixels_results.h"

#include <map>
#include <nlohmann/json.hpp>

#include "results/plan_file.h"

namespace raysweep {

namespace {

PixelsRow row_of(const std::vector<const PixelsRecord*>& rounds) {
  PixelsRow row{*rounds.front(), {}, 0, {}};
  std::vector<double> per_ray;
  for (const PixelsRecord* const round : rounds) {
    if (!round->valid || round->seconds.empty() || round->rays == 0) {
      row.void_rounds++;
      continue;
    }
    if (per_ray.empty()) row.first = *round;
    per_ray.push_back(median(round->seconds) * 1e9 / static_cast<double>(round->rays));
    row.nanoseconds_by_round[round->round] = per_ray.back();
  }
  if (!per_ray.empty()) row.nanoseconds_per_ray = estimate_median(std::move(per_ray));
  return row;
}

}  // namespace

std::vector<PixelsRow> pixels_rows(const std::vector<PixelsRecord>& records,
                                   const std::vector<std::string>& cells) {
  std::map<std::string, std::vector<const PixelsRecord*>> rounds;
  for (const PixelsRecord& record : records) rounds[record.cell].push_back(&record);
  std::vector<PixelsRow> rows;
  for (const std::string& cell : cells) {
    if (const auto found = rounds.find(cell); found != rounds.end()) rows.push_back(row_of(found->second));
  }
  return rows;
}

PixelsData read_pixels_run(const std::filesystem::path& folder) {
  const nlohmann::json plan = read_plan_file(folder);
  try {
    return {plan.at("experiment"), plan.at("title"), plan.at("left_out"),
            pixels_rows(read_pixels_records(folder / "records.jsonl"), plan.at("cells"))};
  } catch (const nlohmann::json::exception& error) {
    throw not_a_plan(folder, error.what());
  }
}

}  // namespace raysweep
