// Printed numbers beside ours.
#include "results/claims/published_rows.h"

#include <gtest/gtest.h>

#include "tests/results/claims/made_up.h"

namespace raysweep {
namespace {

PublishedTable table_of_chunks() {
  PublishedTable table;
  table.quantity = "fps";
  table.rows = {"chunk"};
  table.normalise = "first_row";
  for (const auto& [chunk, low, hard] : {std::tuple("1", "40.0", "4.0"), std::tuple("2", "30.0", "2.0")}) {
    table.numbers.push_back({{{"chunk", chunk}, {"mode", "low"}}, low});
    table.numbers.push_back({{{"chunk", chunk}, {"mode", "hard"}}, hard});
  }
  return table;
}

TEST(published_rows, each_column_is_normalised_by_its_own_first_line) {
  const auto rows = published_rows(table_of_chunks(), {});
  ASSERT_EQ(rows.size(), 4u);
  EXPECT_DOUBLE_EQ(rows[2].printed_normalised.value(), 0.75);
  EXPECT_DOUBLE_EQ(rows[3].printed_normalised.value(), 0.5);
  EXPECT_FALSE(rows[0].ours);
  PublishedTable plain = table_of_chunks();
  plain.normalise = "none";
  EXPECT_FALSE(published_rows(plain, {})[2].printed_normalised);
}

TEST(published_rows, the_table_stands_once_beside_each_variant_of_ours) {
  std::vector<Observation> ours;
  for (const char* scheduler : {"omp_dynamic", "thread_chunks"}) {
    for (const char* chunk : {"1", "2"}) {
      for (const char* mode : {"low", "hard"})
        ours.push_back(
            measured({{"scheduler", scheduler}, {"chunk", chunk}, {"mode", mode}}, chunk[0] == '1' ? 8 : 6));
    }
  }
  ours.push_back(measured({{"scheduler", "serial"}, {"chunk", "9"}, {"mode", "low"}}, 3));
  const auto rows = published_rows(table_of_chunks(), ours);
  ASSERT_EQ(rows.size(), 8u) << "of the serial one nothing is printed";
  EXPECT_EQ(rows[0].factors, (Factors{{"scheduler", "omp_dynamic"}, {"chunk", "1"}, {"mode", "low"}}));
  EXPECT_EQ(rows[6].factors, (Factors{{"scheduler", "thread_chunks"}, {"chunk", "2"}, {"mode", "low"}}));
  EXPECT_NEAR(rows[6].ours.value().value, 6, 1e-9);
  EXPECT_NEAR(rows[6].ours_normalised.value().value, 0.75, 1e-9);
  EXPECT_TRUE(rows[6].ours_normalised->interval);
}

}  // namespace
}  // namespace raysweep
