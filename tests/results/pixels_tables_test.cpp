// Records of pixels experiments, and what tables say of them.
#include "results/tables/pixels_tables.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "results/record.h"

namespace raysweep {
namespace {

/// A round of a picture of 100 pixels and 1000 rays, whose frames took `seconds`.
PixelsRecord made_up(const std::string& cell, int round, std::vector<double> seconds) {
  PixelsRecord r;
  r.experiment = "x";
  r.cell = r.method = cell;
  r.round = round;
  r.scene = "studio";
  r.mode = "low";
  r.width = r.height = 10;
  r.core = "scalar";
  r.precision = "float";
  r.pattern = "grid";
  r.subpixels = r.reference_subpixels = 1;
  r.pixels = 100;
  r.rays = 1000;
  r.seconds = std::move(seconds);
  return r;
}

TEST(pixels_record, comes_back_as_it_was_written) {
  PixelsRecord r = made_up("a", 3, {1, 2.5});
  r.launch = 7, r.seed = 9, r.valid = false, r.reason = "why", r.offset = 1e5, r.wrong_pixels = 4;
  r.hole_pixels = 2, r.nonfinite_pixels = 1, r.flip_mean = 0.1, r.flip_p95 = 0.2, r.flip_max = 0.3;
  r.max_difference = 255, r.rmse = std::numeric_limits<double>::quiet_NaN();
  r.pattern = "circle", r.subpixels = 4, r.reference_subpixels = 1024, r.edge_pixels = 5, r.edge_rmse = 0.25;
  const PixelsRecord back = pixels_record_from_json(nlohmann::json::parse(to_line(r)));
  EXPECT_EQ(to_line(back), to_line(r));
  EXPECT_EQ(back.wrong_pixels, 4u);
  EXPECT_EQ(back.seconds, r.seconds);
  EXPECT_EQ(back.pattern, "circle");
  EXPECT_EQ(back.reference_subpixels, 1024);
  EXPECT_EQ(back.edge_rmse, 0.25);
  EXPECT_TRUE(std::isnan(back.rmse));
}

TEST(pixels_record, of_another_kind_or_schema_is_refused) {
  const auto problem = [](const char* key, const nlohmann::json& value) {
    nlohmann::json json = to_json(made_up("a", 0, {1}));
    json[key] = value;
    try {
      (void)pixels_record_from_json(json);
    } catch (const RecordError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(problem("kind", "accuracy"), "kind \"accuracy\" where \"pixels\" was expected");
  EXPECT_EQ(problem("schema", 1), "schema 1 is unknown here; this version reads 2");
}

/// Rounds of 1, 2, … 7 µs a ray by their median frame: the median is 4, and by order statistics of 7 the
/// interval is from the least to the most.
TEST(pixels_rows, a_ray_takes_the_median_of_the_rounds) {
  std::vector<PixelsRecord> records;
  for (int round = 0; round < 7; ++round) {
    const double seconds = 1e-3 * (round + 1);
    records.push_back(made_up("a", round, {seconds, seconds / 2, 9}));
  }
  const auto rows = pixels_rows(records, {"a"});
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_DOUBLE_EQ(rows[0].nanoseconds_per_ray->value, 4000);
  EXPECT_DOUBLE_EQ(rows[0].nanoseconds_per_ray->interval->low, 1000);
  EXPECT_DOUBLE_EQ(rows[0].nanoseconds_per_ray->interval->high, 7000);
}

TEST(pixels_rows, void_rounds_do_not_count_and_are_told) {
  PixelsRecord bad = made_up("a", 0, {100});
  bad.valid = false;
  bad.wrong_pixels = 50;
  const auto rows = pixels_rows({bad, made_up("a", 1, {1e-3})}, {"a"});
  EXPECT_DOUBLE_EQ(rows[0].nanoseconds_per_ray->value, 1000);
  EXPECT_EQ(rows[0].first.wrong_pixels, 0u);
  EXPECT_EQ(rows[0].void_rounds, 1);
  EXPECT_EQ(pixels_table(rows).rows[0][3], "a (1 rounds void)");
  EXPECT_FALSE(pixels_rows({bad}, {"a"})[0].nanoseconds_per_ray);
}

TEST(pixels_tables, have_the_plans_order_and_no_cell_without_records) {
  const auto rows = pixels_rows({made_up("a", 0, {1}), made_up("b", 0, {1})}, {"b", "c", "a"});
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(rows[0].first.cell, "b");
  EXPECT_EQ(rows[1].first.cell, "a");
}

TEST(pixels_tables, tell_of_few_samples_how_far_they_are_from_many_and_of_rounding_apart) {
  PixelsRecord few = made_up("few", 0, {1e-3});
  few.pattern = "circle", few.subpixels = 4, few.reference_subpixels = 1024;
  few.rmse = 0.02, few.edge_pixels = 7, few.edge_rmse = 0.125, few.flip_mean = 0.01, few.flip_p95 = 0.5;
  const auto rows = pixels_rows({few, made_up("rounded", 0, {1e-3})}, {"few", "rounded"});
  ASSERT_EQ(sampling_table(rows).rows.size(), 1u);
  EXPECT_EQ(sampling_table(rows).rows[0],
            (std::vector<std::string>{"studio", "low", "scalar", "few", "float", "circle", "4", "1024",
                                      "0.02", "7", "0.125", "0.01", "0.5", "1000"}));
  ASSERT_EQ(pixels_table(rows).rows.size(), 1u);
  EXPECT_EQ(pixels_table(rows).rows[0][3], "rounded");
  EXPECT_EQ(pixels_data(rows).rows.size(), 2u);
  const auto text = [](std::vector<PixelsRow> of) {
    return pixels_tables_as_text({"x", "t", {}, std::move(of)});
  };
  EXPECT_NE(text({rows[0]}).find("RMSE at edges"), std::string::npos);
  EXPECT_EQ(text({rows[0]}).find("wrong"), std::string::npos) << "a table without rows";
  EXPECT_EQ(text({rows[1]}).find("RMSE at edges"), std::string::npos);
}

TEST(pixels_tables, tell_errors_beside_times) {
  PixelsRecord r = made_up("wald", 0, {1.5e-3});
  r.offset = 10'000, r.wrong_pixels = 12, r.hole_pixels = 3, r.nonfinite_pixels = 1;
  r.flip_mean = 0.01234, r.flip_p95 = 0.5, r.flip_max = 1, r.max_difference = 255;
  const auto rows = pixels_rows({r}, {"wald"});
  EXPECT_EQ(pixels_table(rows).rows[0],
            (std::vector<std::string>{"studio + 10000", "low", "scalar", "wald", "float", "100", "12", "3",
                                      "1", "0.0123", "0.5", "1", "255", "1500"}));
  const Table data = pixels_data(rows);
  ASSERT_EQ(data.columns.size(), data.rows[0].size());
  EXPECT_EQ(data.rows[0][12], "0.01234");
  EXPECT_EQ(data.rows[0][18], "1500");
  EXPECT_EQ(data.rows[0][19], "") << "one round has no interval";
}

}  // namespace
}  // namespace raysweep
