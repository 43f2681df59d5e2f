#include "results/published.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

#include "results/record.h"

namespace raysweep {
namespace {

TEST(published, twelve_threads_on_six_cores_yield_a_quarter_in_every_mode_of_morozov_2011) {
  const auto yields = published_yields(
      std::filesystem::path(RAYSWEEP_SOURCE_DIR) / "results/published/morozov2011_table3_openmp_fps.csv", 6,
      12);
  const std::pair<const char*, double> expected[] = {
      {"low", 1.25}, {"middle", 1.27}, {"hard", 1.24}, {"very_hard", 1.27}};
  ASSERT_EQ(yields.size(), 4u);
  for (size_t i = 0; i < yields.size(); ++i) {
    EXPECT_EQ(yields[i].mode, expected[i].first);
    EXPECT_NEAR(yields[i].yield, expected[i].second, 0.005) << yields[i].mode;
  }
}

/// What is said of a file with this text.
std::string complaint(const std::string& text) {
  const auto file =
      std::filesystem::temp_directory_path() / ("raysweep_published_" + std::to_string(getpid()));
  std::ofstream(file) << text;
  std::string said;
  try {
    (void)published_yields(file, 1, 2);
  } catch (const RecordError& error) {
    said = std::string(error.what()).substr(file.string().size());
  }
  std::filesystem::remove(file);
  return said;
}

TEST(published, what_is_no_table_of_fps_is_told_with_its_line) {
  EXPECT_EQ(complaint("threads,low\n1,2\n2,3\n"), "");
  EXPECT_EQ(complaint("depth,low\n1,2\n"), ":1: not a table of fps: the first column must be \"threads\"");
  EXPECT_EQ(complaint("threads,low\n1,2\n2,3,4\n"), ":3: not a table of fps: 3 values under 2 columns");
  EXPECT_EQ(complaint("threads,low\n1,fast\n"), ":2: not a table of fps: \"fast\" is no number above 0");
  EXPECT_EQ(complaint("threads,low\n1,0\n"), ":2: not a table of fps: \"0\" is no number above 0");
  EXPECT_EQ(complaint("threads,low\n1,2\n"), ": has no row for 2 threads");
  EXPECT_EQ(complaint(""), ": has no row for 1 threads");
  EXPECT_THROW((void)published_yields("/no/such/file.csv", 1, 2), RecordError);
}

}  // namespace
}  // namespace raysweep
