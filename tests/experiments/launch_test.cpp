// A launch, inside this process.
#include "experiments/launch.h"

#include <gtest/gtest.h>

#include "schedulers/binding.h"

namespace raysweep {
namespace {

Record launched(const Cell& cell) {
  Record result;
  LaunchOptions options;
  options.seconds = 0;
  options.report = [&](const Record& record) { result = record; };
  run_launch(cell, options);
  EXPECT_TRUE(result.valid) << result.reason;
  return result;
}

Cell small_cell(const std::string& scheduler, int threads) {
  Cell cell;
  cell.settings.width = 64;
  cell.settings.height = 48;
  cell.lights = 1;
  cell.scheduler = scheduler;
  cell.threads = threads;
  return cell;
}

TEST(launch, the_serial_base_tells_what_its_items_cost) {
  const Record r = launched(small_cell("serial", 1));
  EXPECT_GT(r.item_seconds.max, 0);
  EXPECT_GE(r.item_seconds.sum, r.item_seconds.max);
  EXPECT_EQ(launched(small_cell("thread_dynamic", 2)).item_seconds.sum, 0) << "others are not slowed down";
}

TEST(launch, a_bound_worker_without_an_item_has_its_processor_all_the_same) {
  Cell cell = small_cell("thread_dynamic", 2);
  cell.item = "tiles:1024";  // one item for two
  cell.pin = "cores";
  const Record r = launched(cell);
  EXPECT_EQ(r.threads_seen, 1);
  EXPECT_EQ(r.processors_seen, static_cast<int>(std::min<size_t>(2, allowed_processors().size())));
}

TEST(launch, a_planted_slowdown_makes_frames_longer_and_not_their_items) {
  Cell cell = small_cell("serial", 1);
  cell.slowdown = 1;
  const Record r = launched(cell);
  ASSERT_GT(r.log_share, 0) << "the log is needed to tell";
  EXPECT_LE(r.workers.front().busy_seconds, r.frame_seconds.front().front() / 2);
  EXPECT_EQ(r.slowdown, 1);
}

TEST(launch, records_what_the_machine_did_meanwhile) {
  const Record r = launched(small_cell("thread_dynamic", 2));
  EXPECT_GT(r.state.wall_seconds.value_or(0), 0);
  EXPECT_GT(r.state.spin_before_seconds.value_or(0), 0);
  EXPECT_GT(r.state.spin_after_seconds.value_or(0), 0);
  EXPECT_TRUE(r.state.involuntary_switches);
}

TEST(launch, what_cannot_afford_the_log_goes_without) {
  Cell cell = small_cell("thread_dynamic", 2);
  cell.item = "tiles:1024";  // one chunk a frame
  EXPECT_GT(launched(cell).log_share, 0);
  cell.item = "pixels";
  cell.settings.depth = 1;
  const Record r = launched(cell);
  EXPECT_EQ(r.log_share, 0);
  EXPECT_TRUE(r.chunk_sizes.empty());
}

}  // namespace
}  // namespace raysweep
