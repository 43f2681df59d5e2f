// What claims can be asked of accuracy and pixels.
#include <gtest/gtest.h>

#include <algorithm>

#include "results/claims/measured_cells.h"
#include "tests/results/accuracy_records.h"

namespace raysweep {
namespace {

MeasuredCell cell_of(const AccuracyRecord& record) {
  return measured_cells(AccuracyData{"x", "t", 1000, {}, AccuracyResults({record})}).at(0);
}

TEST(measured_accuracy, has_every_quantity_that_claims_may_name_where_there_are_errors) {
  AccuracyRecord record = made_up("wald", "W1", 1);
  record.other_nearest = 3;
  const MeasuredCell cell = cell_of(record);
  for (const std::string& quantity : quantities_of("accuracy"))
    EXPECT_TRUE(cell.values.contains(quantity)) << quantity;
  EXPECT_EQ(cell.values.size(), quantities_of("accuracy").size());
  EXPECT_EQ(cell.values.at("t_error_mean").value.value, 0.75);
  EXPECT_EQ(cell.values.at("weight_error_mean").value.value, 8);
  EXPECT_EQ(cell.values.at("other_nearest").value.value, 3);
  EXPECT_TRUE(cell.values.at("other_nearest").exact);
}

TEST(measured_accuracy, has_no_error_where_a_method_gives_none) {
  AccuracyRecord record = made_up("half_spaces", "W1", 1);
  record.weight_error = no_errors();
  EXPECT_FALSE(cell_of(record).values.contains("weight_error_mean"));
  EXPECT_TRUE(cell_of(record).values.contains("t_error_mean"));
}

TEST(measured_pixels, tells_how_they_were_sampled_and_errors_at_edges) {
  PixelsRecord record;
  record.cell = "a";
  record.pattern = "circle", record.subpixels = 4, record.reference_subpixels = 1024;
  record.edge_rmse = 0.25;
  const PixelsData run{"x", "t", {}, pixels_rows({record}, {"a"})};
  const MeasuredCell cell = measured_cells(run).at(0);
  EXPECT_EQ(cell.factors.at("pattern"), "circle");
  EXPECT_EQ(cell.factors.at("subpixels"), "4");
  EXPECT_EQ(cell.values.at("edge_rmse").value.value, 0.25);
  const auto known = quantities_of("pixels");
  EXPECT_NE(std::ranges::find(known, "edge_rmse"), known.end());
}

}  // namespace
}  // namespace raysweep
