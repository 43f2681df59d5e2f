// Pictures as OpenEXR files: every bit of the linear colours, and which primitive each pixel sees.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "tracer/film.h"

namespace raysweep {

/// Writes scan lines of the FLOAT channels R, G and B, linear, and unless `hit_ids` is empty a UINT channel
/// `id`: the primitive that the ray through the pixel's centre meets first, or `no_hit_id`; width·height of
/// them in row order. Compression (ZIP) loses nothing. The file appears whole or not at all.
/// Throws std::runtime_error with a sentence when it cannot be written, std::invalid_argument for a wrong
/// number of ids.
void write_exr(const Film& film, std::span<const uint32_t> hit_ids, const std::string& path);

struct ExrPicture {
  Film film;
  std::vector<uint32_t> hit_ids;  // empty unless the file has a UINT channel `id`
};

struct ExrSize {
  int width, height;
};

/// Size of an EXR file's data window, from its header alone. Throws as read_exr does.
[[nodiscard]] ExrSize exr_size(const std::string& path);

/// Reads the data window of an EXR file, wherever it lies, of scan lines or tiles, with the channels R, G and
/// B as HALF or FLOAT. Throws std::runtime_error with a sentence for what is missing, is no such file, is
/// damaged, or is larger than a picture here may be.
[[nodiscard]] ExrPicture read_exr(const std::string& path);

}  // namespace raysweep
