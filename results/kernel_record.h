// How long one kernel took in one round, on one list of tests or in one of its ways: one line of
// records.jsonl of an experiment of the kind "kernel".
#pragma once

#include <cstdint>
#include <filesystem>
#include <limits>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "results/accuracy_record.h"

namespace raysweep {

/// Older schemas are still read. 2 adds kernels other than intersection, their factors and ticks; 3
/// `scheduler` and `clock`.
inline constexpr int kernel_schema = 3, oldest_kernel_schema = 1;

/// In the place of a scheduler's name: each thread has its own share of the tests, and nothing is handed out.
inline constexpr const char* own_shares = "shares";

/// Of operations timed one by one, in ticks of the clock that machine.json tells.
struct TickRecord {
  double min = 0, avg = 0, max = 0, sum = 0;
  friend bool operator==(const TickRecord&, const TickRecord&) = default;
};

/// The names of its members.
[[nodiscard]] inline std::vector<std::string> tick_statistics() { return {"min", "avg", "max", "sum"}; }

/// What is of tests of rays alone, from `method` to `hit_rate`, other kernels leave empty.
struct KernelRecord {
  int schema = kernel_schema;
  std::string kind = "kernel", experiment, cell;
  int launch = 0, round = 0;
  uint64_t seed = 0;
  bool valid = true;
  std::string reason;                          // why it is not
  std::string kernel;                          // "intersection", or one of those with `factors`
  std::map<std::string, std::string> factors;  // in files "variant"; empty for intersection
  std::string method;
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
  std::string scheduler = own_shares;  // of the tests among threads
  double hit_rate = 0;                 // of the tests, as this kernel found it
  uint64_t tests = 0;                  // a pass; operations of other kernels
  uint64_t iterations = 0;             // passes a sample
  std::vector<double> seconds{};       // a sample each, of `iterations` passes; none if not valid
  std::string clock;                   // of `seconds`: "processor" or "wall"; empty where it is not told
  std::optional<TickRecord> ticks{};   // of the kernels that time every operation

  [[nodiscard]] bool is_intersection() const { return kernel == "intersection"; }
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
