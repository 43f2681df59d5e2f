#include "tracer/film.h"

#include <cmath>
#include <cstdio>
#include <ostream>
#include <stdexcept>

#include "tracer/hash.h"
#include "tracer/whole_file.h"

#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"
#include <stb/stb_image_write.h>
#pragma GCC diagnostic pop

namespace raysweep {

namespace {

void append(void* bytes, void* data, int size) {
  static_cast<std::string*>(bytes)->append(static_cast<const char*>(data), static_cast<size_t>(size));
}

}  // namespace

unsigned char to_srgb_byte(float linear) {
  if (!(linear > 0)) return 0;  // NaN too
  const float c = std::min(linear, 1.0f);
  const float encoded = c <= 0.0031308f ? 12.92f * c : 1.055f * std::pow(c, 1 / 2.4f) - 0.055f;
  return static_cast<unsigned char>(std::lround(encoded * 255));
}

std::string Film::hash() const { return hash_of(pixels_.data(), pixels_.size() * sizeof(Vec3f)); }

void write_png(const Film& film, const std::string& path) {
  if (film.pixels().size() > max_png_pixels)
    throw std::runtime_error(path + ": the picture is too large for a PNG file");
  std::vector<unsigned char> bytes;
  bytes.reserve(film.pixels().size() * 3);
  for (const Vec3f& p : film.pixels()) {
    for (int channel = 0; channel < 3; ++channel) bytes.push_back(to_srgb_byte(p[channel]));
  }
  std::string png;
  if (!stbi_write_png_to_func(append, &png, film.width(), film.height(), 3, bytes.data(), film.width() * 3)) {
    throw std::runtime_error(path + ": the picture could not be encoded as PNG");
  }
  write_whole_file(
      path, [&](std::ostream& file) { file.write(png.data(), static_cast<std::streamsize>(png.size())); });
}

}  // namespace raysweep
