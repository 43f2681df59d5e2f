#include "schedulers/worker_log.h"

#include <gtest/gtest.h>

#include <thread>

#include "schedulers/registry.h"

namespace raysweep {
namespace {

using Sizes = std::vector<std::pair<size_t, size_t>>;

TEST(worker_log, single_items_are_counted_as_runs_of_successive_ones) {
  WorkerLog log(1, LogDetail::times);
  log.begin_run();
  for (const size_t i : {0, 1, 2, 10, 11, 3}) {
    log.begin_item(0, i);
    log.end_chunk(0);
  }
  log.end_run();
  EXPECT_EQ(log.entries()[0].chunks, 3u);
  EXPECT_EQ(log.entries()[0].items, 6u);
  EXPECT_EQ(log.chunk_sizes(), (Sizes{{1, 1}, {2, 1}, {3, 1}}));
}

TEST(worker_log, a_run_goes_on_with_no_chunk_of_the_run_before) {
  WorkerLog log(1, LogDetail::events);
  for (const size_t i : {0, 1}) {
    log.begin_run();
    log.begin_item(0, i);
    log.end_chunk(0);
    log.end_run();
  }
  EXPECT_EQ(log.chunks(), 2u);
  EXPECT_EQ(log.entries()[0].events.size(), 2u);
  EXPECT_EQ(log.chunk_sizes(), (Sizes{{1, 2}}));
}

TEST(worker_log, imbalance_of_one_run_is_not_made_up_for_by_another) {
  WorkerLog log(2, LogDetail::times);
  for (const int busy : {0, 1}) {
    log.begin_run();
    log.begin_chunk(busy, 0, 1);
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
    log.end_chunk(busy);
    log.end_run();
  }
  EXPECT_NEAR(log.imbalance(), 1, 1e-9) << "in each run one worker did it all";
}

TEST(worker_log, neighbouring_chunks_stay_two_chunks) {
  WorkerLog log(2, LogDetail::times);
  log.begin_run();
  for (const size_t i : {0, 4}) {
    log.begin_chunk(1, i, 4);
    log.end_chunk(1);
  }
  log.end_run();
  EXPECT_EQ(log.entries()[1].chunks, 2u);
  EXPECT_EQ(log.chunk_sizes(), (Sizes{{4, 2}}));
  EXPECT_EQ(log.workers_seen(), 1);
}

/// The identity that makes the accounting whole: no microsecond of any worker is missing or there twice.
TEST(worker_log, busy_scheduling_and_idle_are_all_the_time_of_all_workers) {
  constexpr int threads = 3;
  const auto scheduler = make_scheduler("thread_dynamic", {.threads = threads});
  WorkerLog log(threads, LogDetail::events);
  const Body body = [](size_t begin, size_t, int) {
    std::this_thread::sleep_for(std::chrono::microseconds(100 * (begin % 5)));
  };
  for (int run = 0; run < 3; ++run) scheduler->run({20}, {3}, body, log);
  std::chrono::nanoseconds of_runs{0}, of_workers{0};
  for (const auto& [begin, end] : log.runs()) of_runs += end - begin;
  for (const WorkerEntry& entry : log.entries()) {
    of_workers += entry.busy + entry.scheduling + entry.idle;
    std::chrono::nanoseconds busy{0};
    for (const ChunkEvent& event : entry.events) busy += event.end - event.begin;
    EXPECT_EQ(busy, entry.busy);
    EXPECT_EQ(entry.events.size(), entry.chunks);
    EXPECT_GE(entry.scheduling.count(), 0);
    EXPECT_GE(entry.idle.count(), 0);
  }
  EXPECT_EQ(of_workers, threads * of_runs);
}

TEST(worker_log, counts_alone_read_no_clock) {
  const auto scheduler = make_scheduler("thread_dynamic", {.threads = 2});
  WorkerLog log(2);
  scheduler->run(
      {20}, {3}, [](size_t, size_t, int) {}, log);
  EXPECT_EQ(log.chunks(), 7u);
  EXPECT_TRUE(log.runs().empty());
  for (const WorkerEntry& entry : log.entries()) EXPECT_EQ(entry.busy.count() + entry.idle.count(), 0);
}

}  // namespace
}  // namespace raysweep
