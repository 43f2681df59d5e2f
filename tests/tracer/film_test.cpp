#include "tracer/film.h"

#include <gtest/gtest.h>

#include <bit>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace raysweep {
namespace {

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
  EXPECT_FALSE(std::filesystem::exists(file.string() + ".part"));
  std::filesystem::remove(file);
}

TEST(film, a_picture_that_cannot_be_written_is_told_and_leaves_nothing) {
  EXPECT_THROW(write_png(Film(1, 1), "/nonexistent/picture.png"), std::runtime_error);
}

}  // namespace
}  // namespace raysweep
