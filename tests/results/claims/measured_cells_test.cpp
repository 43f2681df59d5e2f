// Records of each kind as observations: every factor and quantity by its name.
#include "results/claims/measured_cells.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/results/accuracy_records.h"
#include "tests/results/make_record.h"

namespace raysweep {
namespace {

/// Each quantity and factor that cells have is one that configs may name, and the other way round.
void expect_known(const MeasuredCell& cell, const std::string& kind) {
  const auto quantities = quantities_of(kind);
  for (const auto& [name, value] : cell.values)
    EXPECT_NE(std::ranges::find(quantities, name), quantities.end()) << name << " of " << kind;
  for (const std::string& name : factors_of(kind)) EXPECT_TRUE(cell.factors.contains(name)) << name;
  EXPECT_EQ(cell.factors.size(), factors_of(kind).size());
}

TEST(measured_cells, of_pictures_pair_launches_of_a_round) {
  RunData run;
  std::vector<Record> planned;
  for (int round = 0; round < 3; ++round) {
    for (const auto& [scheduler, threads, seconds] :
         {std::tuple("serial", 1, 4.0), std::tuple("omp_static", 1, 5.0), std::tuple("omp_static", 2, 2.0)}) {
      Record r = make_record(scheduler, threads, round, seconds * (1 + round));
      r.item_seconds = {seconds * (1 + round), 0.5};
      r.chunks_made = {3, 5, 4};
      r.rays = {10, 20, 30, 40};
      r.empty_region_seconds = 1e-6;
      if (round == 0) planned.push_back(r);
      run.records.push_back(r);
    }
  }
  planned.push_back(make_record("omp_static", 8, 0, 0));
  run.rows = summarise(run.records, planned, 0.02);
  const auto cells = measured_cells(run);
  ASSERT_EQ(cells.size(), 4u);
  const MeasuredCell& two = cells[2];
  expect_known(two, "picture");
  EXPECT_EQ(two.factors.at("threads"), "2");
  EXPECT_EQ(two.values.at("fps").by_round, (std::map<int, double>{{0, 0.5}, {1, 0.25}, {2, 1 / 6.0}}));
  EXPECT_EQ(two.values.at("frame_seconds").value.value, 4);
  EXPECT_DOUBLE_EQ(two.values.at("speedup").by_round.at(2), 2);
  EXPECT_DOUBLE_EQ(two.values.at("speedup_one").by_round.at(1), 2.5);
  EXPECT_DOUBLE_EQ(two.values.at("quality").by_round.at(0), 1) << "half of 4 s is what 2 s could be";
  EXPECT_EQ(two.values.at("chunks").value.value, 4);
  EXPECT_TRUE(two.values.at("rays").exact);
  EXPECT_EQ(two.values.at("rays").value.value, 100);
  EXPECT_EQ(cells[3].values.at("fps").value.count, 0) << "planned, and not measured";
  EXPECT_EQ(observations_of(cells).at("fps").size(), 4u);
  EXPECT_EQ(observations_of(cells).at("speedup").size(), 3u);
}

TEST(measured_cells, of_kernels_are_nanoseconds_by_round) {
  std::vector<KernelRecord> records;
  for (int round = 0; round < 2; ++round) {
    KernelRecord& r = records.emplace_back();
    r.kernel = "intersection", r.method = "wald", r.change = "rays=8", r.protocol = "hit-rate";
    r.parameter = 0.3, r.round = round, r.tests = 1000, r.iterations = 10, r.bytes = 48, r.rays_at_once = 8;
    r.seconds.assign(3, (2 + round) * 1e-9 * 1000 * 10);
  }
  const auto cells = measured_cells(KernelData{"x", "t", 2, 1, {}, KernelResults(records)});
  ASSERT_EQ(cells.size(), 1u);
  expect_known(cells[0], "kernel");
  EXPECT_EQ(cells[0].factors.at("parameter"), "0.3");
  EXPECT_EQ(cells[0].factors.at("rays_at_once"), "8");
  EXPECT_EQ(cells[0].factors.at("scene"), "none") << "not \"-\", which is as good as any value";
  EXPECT_NEAR(cells[0].values.at("nanoseconds").by_round.at(1), 3, 1e-9);
}

TEST(measured_cells, of_accuracy_are_exact) {
  AccuracyRecord record = made_up("wald", "W1", 1);
  record.false_misses = 7;
  record.uv_error = no_errors();
  const auto cells = measured_cells(AccuracyData{"x", "t", 1000, {}, AccuracyResults({record})});
  ASSERT_EQ(cells.size(), 1u);
  expect_known(cells[0], "accuracy");
  EXPECT_EQ(cells[0].factors.at("difficulty"), "0.1");
  EXPECT_EQ(cells[0].values.at("false_misses").value.value, 7);
  EXPECT_TRUE(cells[0].values.at("t_error_p99").exact);
  EXPECT_EQ(cells[0].values.at("t_error_p99").value.value, 2);
  EXPECT_FALSE(cells[0].values.contains("uv_error_p99")) << "nothing was hit that could be wrong";
}

TEST(measured_cells, of_pixels_have_exact_errors_and_times_by_round) {
  std::vector<PixelsRecord> records(2);
  for (int round = 0; round < 2; ++round) {
    PixelsRecord& r = records[static_cast<size_t>(round)];
    r.cell = "a", r.scene = "studio", r.offset = 1e5, r.rays = 1000, r.round = round, r.wrong_pixels = 4;
    r.seconds = {(1 + round) * 1e-6};
  }
  const auto cells = measured_cells(PixelsData{"x", "t", {}, pixels_rows(records, {"a"})});
  ASSERT_EQ(cells.size(), 1u);
  expect_known(cells[0], "pixels");
  EXPECT_EQ(cells[0].factors.at("offset"), "100000");
  EXPECT_EQ(cells[0].values.at("wrong_pixels").value.value, 4);
  EXPECT_NEAR(cells[0].values.at("nanoseconds").by_round.at(1), 2, 1e-9);
}

}  // namespace
}  // namespace raysweep
