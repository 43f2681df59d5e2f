// How long one kernel took on one list of tests in one round: one line of records.jsonl of an experiment of
// the kind "kernel".
#pragma once

#include <cstdint>
#include <filesystem>
#include <limits>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "results/accuracy_record.h"

namespace raysweep {

inline constexpr int kernel_schema = 1;

struct KernelRecord {
  int schema = kernel_schema;
  std::string kind = "kernel", experiment, cell;
  int launch = 0, round = 0;
  uint64_t seed = 0;
  bool valid = true;
  std::string reason;  // why it is not
  std::string kernel, method;
  std::string change;  // what differs from the method's base kernel: "rays=8"; "base" for itself
  VariantRecord variant;
  std::string precision;
  int rays_at_once = 1, triangles_at_once = 1;
  std::string layout, contraction, compiler, isa;
  uint64_t bytes = 0;  // that a test reads of a triangle
  std::string protocol;
  double parameter = std::numeric_limits<double>::quiet_NaN();  // the protocol's, such as the hit rate asked
  std::string scene;                                            // empty where the protocol has none
  int threads = 1;
  double hit_rate = 0;      // of the tests, as this kernel found it
  uint64_t tests = 0;       // a pass
  uint64_t iterations = 0;  // passes a sample
  // A sample each, of `iterations` passes: processor time, with several threads wall time. None if not valid.
  std::vector<double> seconds{};
};

/// NaN is null in JSON.
[[nodiscard]] nlohmann::json to_json(const KernelRecord& record);
/// One line of records.jsonl, without its newline.
[[nodiscard]] std::string to_line(const KernelRecord& record);
/// Throws RecordError for another kind or schema, and nlohmann's exceptions for what is no record.
[[nodiscard]] KernelRecord kernel_record_from_json(const nlohmann::json& json);

/// All whole records of a file, in order; a last line without its end is left out. Throws RecordError as
/// `read_records`.
[[nodiscard]] std::vector<KernelRecord> read_kernel_records(const std::filesystem::path& file);

}  // namespace raysweep
