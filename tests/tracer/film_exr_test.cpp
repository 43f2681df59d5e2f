#include "tracer/film_exr.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfOutputFile.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <bit>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <stdexcept>

#include "tracer/whole_file.h"

namespace raysweep {
namespace {

namespace fs = std::filesystem;

class Exr : public testing::Test {
 protected:
  Exr() { fs::create_directories(folder_); }
  ~Exr() override { fs::remove_all(folder_); }
  [[nodiscard]] std::string path(const char* name) const { return (folder_ / name).string(); }
  [[nodiscard]] size_t file_count() const {
    return static_cast<size_t>(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
  }

 private:
  fs::path folder_ = fs::temp_directory_path() / ("raysweep_exr_test_" + std::to_string(getpid()));
};

std::string reading_problem(const std::string& path) {
  try {
    (void)read_exr(path);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return {};
}

Film some_film(int width, int height) {
  Film film(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x)
      film.at(x, y) = {0.1f * static_cast<float>(x), -1.0f / static_cast<float>(y + 1),
                       static_cast<float>(x * y)};
  }
  return film;
}

/// Writes channels of one type, all bytes 0 but for the first pixel's first bytes, as another program may.
void write_foreign(const std::string& path, const Imath::Box2i& window,
                   std::initializer_list<const char*> names, Imf::PixelType type, uint32_t first_bits = 0) {
  Imf::Header header(window, window);
  Imf::FrameBuffer buffer;
  const auto width = static_cast<size_t>(window.max.x - window.min.x + 1);
  std::vector<uint32_t> pixels(width * static_cast<size_t>(window.max.y - window.min.y + 1));
  pixels[0] = first_bits;
  for (const char* name : names) {
    header.channels().insert(name, Imf::Channel(type));
    buffer.insert(name, Imf::Slice::Make(type, pixels.data(), window, sizeof(uint32_t)));
  }
  Imf::OutputFile file(path.c_str(), header, 0);
  file.setFrameBuffer(buffer);
  file.writePixels(window.max.y - window.min.y + 1);
}

TEST_F(Exr, every_bit_of_a_picture_comes_back) {
  Film film = some_film(37, 41);
  film.at(0, 0) = {std::numeric_limits<float>::infinity(), -std::numeric_limits<float>::infinity(), -0.0f};
  film.at(36, 40) = {std::bit_cast<float>(0x7fc12345u), std::bit_cast<float>(1u), 3e38f};
  write_exr(film, {}, path("a.exr"));
  const ExrPicture back = read_exr(path("a.exr"));
  EXPECT_EQ(back.film.width(), 37);
  EXPECT_EQ(back.film.height(), 41);
  EXPECT_EQ(back.film.hash(), film.hash());
  EXPECT_TRUE(back.hit_ids.empty());
  EXPECT_EQ(file_count(), 1u) << "no part stays";
}

TEST_F(Exr, hit_ids_come_back) {
  const Film film = some_film(5, 3);
  std::vector<uint32_t> ids;
  for (uint32_t i = 0; i < 15; ++i) ids.push_back(i % 4 ? 0x01000001u * i : no_hit_id);
  write_exr(film, ids, path("a.exr"));
  const ExrPicture back = read_exr(path("a.exr"));
  EXPECT_EQ(back.hit_ids, ids);
  EXPECT_EQ(back.film.hash(), film.hash());
  EXPECT_THROW(write_exr(film, std::span(ids).first(14), path("b.exr")), std::invalid_argument);
  EXPECT_EQ(file_count(), 1u);
}

TEST_F(Exr, a_picture_is_written_the_same_every_time) {
  const auto bytes = [&](const char* name) {
    write_exr(some_film(40, 40), {}, path(name));
    std::ifstream in(path(name), std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(in), {});
  };
  EXPECT_EQ(bytes("a.exr"), bytes("b.exr"));
}

TEST_F(Exr, a_data_window_may_lie_anywhere) {
  for (const Imath::V2i& origin : {Imath::V2i(7, 11), Imath::V2i(-1000000, -3), Imath::V2i(0, 2000000)}) {
    write_foreign(path("a.exr"), {origin, origin + Imath::V2i(4, 2)}, {"R", "G", "B"}, Imf::FLOAT,
                  std::bit_cast<uint32_t>(2.5f));
    const Film film = read_exr(path("a.exr")).film;
    EXPECT_EQ(film.width(), 5);
    EXPECT_EQ(film.height(), 3);
    EXPECT_EQ(film.at(0, 0), Vec3f(2.5f, 2.5f, 2.5f));
    EXPECT_EQ(film.at(4, 2), Vec3f());
  }
}

TEST_F(Exr, half_precision_is_read) {
  write_foreign(path("a.exr"), {{0, 0}, {1, 1}}, {"R", "G", "B", "A"}, Imf::HALF, 0x3e00);  // 1.5
  EXPECT_EQ(read_exr(path("a.exr")).film.at(0, 0), Vec3f(1.5f, 1.5f, 1.5f));
}

TEST_F(Exr, an_id_channel_that_holds_no_whole_numbers_is_not_hit_ids) {
  write_foreign(path("a.exr"), {{0, 0}, {1, 1}}, {"R", "G", "B", "id"}, Imf::FLOAT);
  EXPECT_TRUE(read_exr(path("a.exr")).hit_ids.empty());
}

TEST_F(Exr, what_cannot_be_read_is_told) {
  EXPECT_EQ(reading_problem(path("none.exr")),
            path("none.exr") + ": cannot be opened: No such file or directory");
  std::ofstream(path("text.exr")) << "This is a text.\n";
  EXPECT_EQ(reading_problem(path("text.exr")), path("text.exr") + ": is not an EXR file");
  std::ofstream(path("empty.exr")).close();
  EXPECT_EQ(reading_problem(path("empty.exr")), path("empty.exr") + ": is not an EXR file");
  EXPECT_NE(reading_problem(fs::path(path("x")).parent_path().string()), "") << "a folder";
}

TEST_F(Exr, channels_that_are_missing_are_told) {
  write_foreign(path("grey.exr"), {{0, 0}, {1, 1}}, {"Y"}, Imf::FLOAT);
  EXPECT_EQ(reading_problem(path("grey.exr")),
            path("grey.exr") + ": has no channel R of half or float at every pixel; R, G and B are needed");
  write_foreign(path("whole.exr"), {{0, 0}, {1, 1}}, {"R", "G", "B"}, Imf::UINT);
  EXPECT_NE(reading_problem(path("whole.exr")), "");
}

TEST_F(Exr, a_picture_that_is_too_large_is_told) {
  write_foreign(path("wide.exr"), {{0, 0}, {40000, 0}}, {"R", "G", "B"}, Imf::HALF);
  EXPECT_EQ(reading_problem(path("wide.exr")),
            path("wide.exr") + ": 40001 × 1 pixels are too large; at most 32768 × 32768 are possible");
}

TEST_F(Exr, a_file_that_is_cut_short_is_told_wherever_the_cut_is) {
  write_exr(some_film(64, 64), {}, path("a.exr"));
  const auto size = fs::file_size(path("a.exr"));
  for (uintmax_t kept = size - 1; kept > 8; kept = kept * 9 / 10) {
    fs::resize_file(path("a.exr"), kept);
    EXPECT_TRUE(reading_problem(path("a.exr")).starts_with(path("a.exr") + ": is ")) << kept;
  }
}

TEST_F(Exr, what_cannot_be_written_is_told_and_leaves_nothing) {
  const auto problem = [](const std::string& file) -> std::string {
    try {
      write_exr(Film(2, 2), {}, file);
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return {};
  };
  EXPECT_EQ(problem("/nonexistent/a.exr"),
            "/nonexistent/a.exr: cannot be written: No such file or directory");
  fs::create_directory(path("folder.exr"));
  EXPECT_EQ(problem(path("folder.exr")), path("folder.exr") + ": cannot be written: Is a directory");
  EXPECT_EQ(file_count(), 1u) << "the folder alone";
  if (fs::exists("/dev/full")) {
    fs::create_symlink("/dev/full", part_of(path("full.exr")));
    EXPECT_EQ(problem(path("full.exr")), path("full.exr") + ": cannot be written: No space left on device");
    EXPECT_EQ(file_count(), 1u);
  }
}

}  // namespace
}  // namespace raysweep
