#include "experiments/overhead/row_samples.h"

#include <nlohmann/json.hpp>

namespace raysweep {

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(SizeSample, iterations, seconds)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(BurnSample, cpu_seconds, went_quiet)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(RowSamples, region_seconds, chunks_seconds, chunks, tasks, sizes, burns)

std::string to_line(const RowSamples& samples) { return nlohmann::json(samples).dump(); }

RowSamples row_samples_from_line(const std::string& line) {
  return nlohmann::json::parse(line).get<RowSamples>();
}

}  // namespace raysweep
