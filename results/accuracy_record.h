// How one method of intersection did on one case at one difficulty: one line of records.jsonl of an
// experiment of the kind "accuracy". The same config, seed and program give the same bytes.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace raysweep {

/// 2 adds launch, round, valid and reason, which records of every kind have; 3 other_nearest, weight_error
/// and the means of errors.
inline constexpr int accuracy_schema = 3;

/// The factors of a variant, by the names that the study has for their values.
struct VariantRecord {
  std::string division, reciprocal, order, edges, early_out, output, data;
  friend bool operator==(const VariantRecord&, const VariantRecord&) = default;
};

/// Quantiles of errors, and their mean. Without errors, `count` is 0 and the others are NaN, in JSON null.
struct ErrorRecord {
  uint64_t count = 0;
  double p50, p99, p999, max, mean;
};

/// Counts are of trials, a ray with one triangle each, or of rays, where they say so. By the oracle a trial
/// is a hit, a miss or a boundary, for which either answer is right.
///
/// Of what records of every kind have, `machine` is left to machine.json: a load or a clock frequency in it
/// would differ from one run to the next, and the same seed gives the same bytes.
struct AccuracyRecord {
  int schema = accuracy_schema;
  std::string kind = "accuracy", experiment, cell;
  int launch = 0, round = 0;  // always 0: each cell is run once, and again it would count the same
  uint64_t seed = 0;
  bool valid = true;           // always: what stops a cell leaves no record of it
  std::string reason;          // empty
  std::string method, change;  // what differs from the method's base variant: "division=late"; else "base"
  VariantRecord variant;
  std::string precision, case_id, difficulty_of;  // what the difficulty is, and its unit
  double difficulty = 0;
  int level = 0;                     // its place among the case's difficulties, 0 the easiest
  uint64_t rays = 0, mesh_rays = 0;  // the latter have two candidates or more, of one mesh
  uint64_t trials = 0, hits = 0, boundary = 0;
  uint64_t false_hits = 0, false_misses = 0;
  uint64_t nonfinite = 0;  // hits with a number that is infinite or NaN
  // Of mesh rays: no hit where the oracle has one or a boundary; more than the oracle's hits and boundaries;
  // neither hit nor boundary by the oracle.
  uint64_t missed_rays = 0, extra = 0, uncovered = 0;
  // Mesh rays whose nearest hit is another triangle than the oracle's, or one hits and the other does not.
  // Not where a boundary or two hits at one t leave the choice open, nor of variants that give no t.
  uint64_t other_nearest = 0;
  ErrorRecord t_error;       // |t − t*| / (ε·|t*|), ε from 1 to the next number
  ErrorRecord uv_error;      // max(|β − β*|, |γ − γ*|)
  ErrorRecord weight_error;  // |β − β*| / (ε·|β*|), and the same of γ: two of a hit
  ErrorRecord consistency;   // between O + tD and P(β, γ), in ε of the largest coordinate
  ErrorRecord off_plane;     // of O + tD from the plane, likewise
};

/// In files "case" and "difficulty_of" hold `case_id` and what the difficulty is.
[[nodiscard]] nlohmann::json to_json(const AccuracyRecord& record);
/// One line of records.jsonl, without its newline.
[[nodiscard]] std::string to_line(const AccuracyRecord& record);
/// Throws RecordError for another kind or schema, and nlohmann's exceptions for what is no record.
[[nodiscard]] AccuracyRecord accuracy_record_from_json(const nlohmann::json& json);

/// All whole records of a file, in order; a last line without its end is left out. Throws RecordError as
/// `read_records`.
[[nodiscard]] std::vector<AccuracyRecord> read_accuracy_records(const std::filesystem::path& file);

}  // namespace raysweep
