// How far one way to make a picture is from a reference, and what it took in one round:
// one line of records.jsonl of an experiment of the kind "pixels".
#pragma once

#include <cstdint>
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace raysweep {

/// 2 adds how the picture and its reference are sampled, and edges.
inline constexpr int pixels_schema = 2;

/// Errors are those of one picture, the same in all rounds; times are this round's.
struct PixelsRecord {
  int schema = pixels_schema;
  std::string kind = "pixels", experiment, cell;
  int launch = 0, round = 0;  // the place in the order of the run; the round of the cell, from 0
  uint64_t seed = 0;          // of the order in rounds
  bool valid = true;          // whether every frame was the same picture, bit for bit
  std::string reason;         // why it is not valid; else empty
  std::string scene;
  double offset = 0;  // how far the scene was moved along each axis, in its units of length
  std::string mode;
  int width = 0, height = 0;  // pixels
  std::string core, method, precision;
  std::string pattern;                         // where in a pixel its samples lie
  int subpixels = 0, reference_subpixels = 0;  // samples a pixel, and those of the reference
  uint64_t pixels = 0;
  uint64_t wrong_pixels = 0;      // more than 1 of 255 off in a channel
  uint64_t hole_pixels = 0;       // whose centre sees nothing where the reference sees something
  uint64_t nonfinite_pixels = 0;  // with a channel that is infinite or NaN
  double flip_mean = 0, flip_p95 = 0, flip_max = 0;  // over the pixels' FLIP, 0 to 1
  int max_difference = 0;                            // of a channel, of 255
  double rmse = 0;              // of linear channels; NaN, in JSON null, of no finite pixel
  uint64_t edge_pixels = 0;     // at edges of the reference: see experiments/picture_edges.h
  double edge_rmse = 0;         // over them
  uint64_t rays = 0;            // of one frame, of all kinds
  std::vector<double> seconds;  // of each timed frame, on one thread
};

[[nodiscard]] nlohmann::json to_json(const PixelsRecord& record);
/// One line of records.jsonl, without its newline.
[[nodiscard]] std::string to_line(const PixelsRecord& record);
/// Throws RecordError for another kind or schema, and nlohmann's exceptions for what is no record.
[[nodiscard]] PixelsRecord pixels_record_from_json(const nlohmann::json& json);

/// All whole records of a file, in order; a last line without its end is left out. Throws RecordError as
/// `read_records`.
[[nodiscard]] std::vector<PixelsRecord> read_pixels_records(const std::filesystem::path& file);

}  // namespace raysweep
