// Cells of the accuracy study: a method in a variant and a precision, on a case at a difficulty.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/intersection/case.h"
#include "results/accuracy_record.h"

namespace raysweep {

enum class Precision { float_precision, double_precision };
[[nodiscard]] constexpr std::string_view name_of(Precision precision) {
  return precision == Precision::float_precision ? "float" : "double";
}

/// Methods and variants that are tried on the same trials, which the oracle judges once.
struct AccuracyBatch {
  const Case* one = nullptr;
  size_t level = 0;  // index of the case's difficulties
  Precision precision{};
  std::vector<size_t> subjects{};  // indices of `run_subjects` of that precision
};

/// What a batch is run with. Each cell has `ray_count` rays; all draw them from the same `seed`.
struct AccuracySettings {
  std::string experiment;
  uint64_t seed = 1;
  size_t ray_count = 0;
};

/// All subjects of both precisions on a case, level by level.
[[nodiscard]] std::vector<AccuracyBatch> all_batches(const Case& one);

/// The key of a batch's cell: "wald/division=late/float/W1/0.5".
[[nodiscard]] std::string cell_key(const AccuracyBatch& batch, size_t subject);

/// The records of a batch, in the order of its subjects. Once `stops()` is true, the rest is left out.
/// Batches may be run at the same time.
[[nodiscard]] std::vector<AccuracyRecord> run_batch(const AccuracyBatch& batch,
                                                    const AccuracySettings& settings,
                                                    const std::function<bool()>& stops);

}  // namespace raysweep
