#include "tracer/film.h"

#include <gtest/gtest.h>

#include <bit>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "tracer/whole_file.h"

#define STB_IMAGE_IMPLEMENTATION
#define STBI_ONLY_PNG
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wsign-conversion"
#pragma GCC diagnostic ignored "-Wunused-function"
#include <stb/stb_image.h>
#pragma GCC diagnostic pop

namespace raysweep {
namespace {

// Where rows are whole lines, tiles then share none with their neighbours.
TEST(film, begins_with_a_cache_line) {
  for (const int width : {1, 3, 16, 17, 640}) {
    const Film film(width, 3);
    EXPECT_EQ(reinterpret_cast<uintptr_t>(film.pixels().data()) % 64, 0u) << width;
  }
}

TEST(film, the_hash_sees_every_bit_of_every_pixel) {
  Film film(3, 2);
  const std::string empty = film.hash();
  EXPECT_EQ(empty.size(), 32u);
  film.at(2, 1).z = std::bit_cast<float>(1u);  // the smallest float above 0
  EXPECT_NE(film.hash(), empty);
  film.at(2, 1).z = 0;
  EXPECT_EQ(film.hash(), empty);
}

TEST(film, a_png_is_written_whole_with_its_size) {
  const auto file = std::filesystem::temp_directory_path() / "raysweep_film_test.png";
  write_png(Film(300, 5), file.string());
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  const std::string png = text.str();
  ASSERT_GT(png.size(), 24u);
  EXPECT_EQ(png.substr(1, 3), "PNG");
  const auto big_endian = [&](size_t at) {
    return static_cast<unsigned char>(png[at + 2]) * 256 + static_cast<unsigned char>(png[at + 3]);
  };
  EXPECT_EQ(big_endian(16), 300);
  EXPECT_EQ(big_endian(20), 5);
  EXPECT_NE(png.find("IEND"), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(part_of(file.string())));
  std::filesystem::remove(file);
}

TEST(film, a_png_holds_the_colours_as_srgb_where_they_are) {
  Film film(2, 2);
  film.at(0, 0) = {1, 0, 0};
  film.at(1, 0) = {0, 0.5f, 2};              // 0.5 is 188 in sRGB (IEC 61966-2-1); 2 is clamped
  film.at(0, 1) = {-1, 0.002f, 0.0031308f};  // 0.002 · 12.92 · 255 = 6.6
  const auto file = std::filesystem::temp_directory_path() / "raysweep_film_colours.png";
  write_png(film, file.string());
  int width = 0, height = 0, channels = 0;
  unsigned char* const bytes = stbi_load(file.c_str(), &width, &height, &channels, 3);
  ASSERT_NE(bytes, nullptr);
  EXPECT_EQ((std::vector<int>(bytes, bytes + 12)),
            (std::vector<int>{255, 0, 0, 0, 188, 255, 0, 7, 10, 0, 0, 0}));
  stbi_image_free(bytes);
  std::filesystem::remove(file);
}

TEST(film, a_picture_that_cannot_be_written_is_told_and_leaves_nothing) {
  EXPECT_THROW(write_png(Film(1, 1), "/nonexistent/picture.png"), std::runtime_error);
}

}  // namespace
}  // namespace raysweep
