// Many chunks, many threads, many runs, over the whole registry.
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "tests/schedulers/conformance.h"

namespace raysweep {
namespace {

class Many : public Conformance {};
INSTANTIATE_TEST_SUITE_P(registry, Many, testing::ValuesIn(available_schedulers()),
                         [](const auto& i) { return i.param.name(); });

/// Threads of this process, by the kernel's account.
long threads_here() {
  return std::distance(std::filesystem::directory_iterator("/proc/self/task"),
                       std::filesystem::directory_iterator());
}

/// Bytes of this process in memory.
long resident_bytes() {
  std::ifstream statm("/proc/self/statm");
  long size = 0, resident = 0;
  statm >> size >> resident;
  return resident * sysconf(_SC_PAGESIZE);
}

TEST_P(Many, one_item_chunks_by_the_million_run_once_each) {
  // A task for each chunk is memory for each chunk, made by one worker: there, fewer.
  const bool task_per_chunk = name() == "omp_taskloop" || name() == "tbb_task_group";
  const size_t count = unless_sanitized<size_t>(task_per_chunk ? 100'000 : 1'000'000, 10'000);
  const auto scheduler = make(4);
  std::vector<std::atomic<unsigned char>> runs(count);
  WorkerLog log(4);
  const auto body = [&](size_t begin, size_t end, int) {
    for (size_t i = begin; i < end; ++i) runs[i].fetch_add(1, std::memory_order_relaxed);
  };
  scheduler->run({count}, {1}, body, log);
  EXPECT_EQ(std::ranges::count_if(runs, [](const auto& n) { return n.load() == 1; }),
            static_cast<std::ptrdiff_t>(count));
}

TEST_P(Many, more_threads_than_items_leave_some_without) {
  constexpr int threads = 8;
  const auto scheduler = make(threads);
  for (size_t count = 0; count < threads; ++count) {
    for (const int chunk : {1, 2, 100}) {
      std::vector<std::atomic<int>> runs(count);
      WorkerLog log(threads);
      scheduler->run(
          {count}, {chunk},
          [&](size_t begin, size_t end, int) {
            for (size_t i = begin; i < end; ++i) runs.at(i)++;
          },
          log);
      for (size_t i = 0; i < count; ++i) EXPECT_EQ(runs[i], 1) << "item " << i << " of " << count;
      EXPECT_LE(log.workers_seen(), static_cast<int>(count));
    }
  }
}

/// Oversubscription is slow, but whole: each worker really runs, though they must share processors.
TEST_P(Many, more_threads_than_processors_all_run) {
  const int threads = std::max(16, 4 * static_cast<int>(allowed_processors().size()));
  const auto scheduler = make(threads);
  Meeting meeting(workers(threads));
  std::atomic<size_t> items{0};
  WorkerLog log(threads);
  const auto body = [&](size_t begin, size_t end, int worker) {
    meeting.first_of(worker);
    items += end - begin;
  };
  scheduler->run({static_cast<size_t>(threads) * 16}, {1}, body, log);
  EXPECT_TRUE(meeting.complete());
  EXPECT_EQ(log.workers_seen(), workers(threads));
  EXPECT_EQ(items, static_cast<size_t>(threads) * 16);
}

TEST_P(Many, ten_thousand_runs_keep_no_thread_and_no_memory) {
  // thread_spawn makes its threads in each run, which is slow under sanitizers, as is memory.
  const int runs = unless_sanitized(10'000, name() == "thread_spawn" ? 300 : 1'000);
  const auto scheduler = make(4);
  std::atomic<size_t> items{0};
  const auto run = [&] {
    WorkerLog log(4);
    scheduler->run(
        {16}, {2}, [&](size_t begin, size_t end, int) { items += end - begin; }, log);
  };
  for (int i = 0; i < 100; ++i) run();
  const long threads = threads_here(), memory = resident_bytes();
  for (int i = 100; i < runs; ++i) run();
  EXPECT_EQ(threads_here(), threads);
  EXPECT_EQ(items, static_cast<size_t>(runs) * 16);
  // 100 bytes a run would be 1 MiB: what allocators keep is less. TBB's partitioners that mail tasks to
  // workers keep what waits for workers that sleep: 5 MiB after 10,000 runs, 9 MiB after 3 million.
  // Sanitizers' own books grow by more.
  const bool mails = name() == "tbb_static" || name() == "tbb_affinity";
  EXPECT_LT(resident_bytes() - memory, unless_sanitized(mails ? 16 << 20 : 1 << 20, 64 << 20));
}

}  // namespace
}  // namespace raysweep
