// What every scheduler promises, over the whole registry.
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <mutex>
#include <set>
#include <thread>

#include "schedulers/registry.h"
#include "tests/schedulers/available.h"

namespace raysweep {
namespace {

class Conformance : public testing::TestWithParam<Tested> {
 public:
  [[nodiscard]] const SchedulerInfo& info() const { return *find_scheduler(GetParam().scheduler); }
  [[nodiscard]] std::unique_ptr<Scheduler> make(int threads) const {
    return make_scheduler(GetParam().scheduler, {.threads = threads, .runtime = GetParam().runtime});
  }
  /// CTest gives each test a process of its own; whoever runs them all in one gets one OpenMP runtime.
  void SetUp() override {
    static std::string openmp;
    if (GetParam().runtime.empty()) return;
    if (openmp.empty()) openmp = GetParam().runtime;
    if (openmp != GetParam().runtime) GTEST_SKIP() << openmp << " is in this process already";
  }
  [[nodiscard]] int workers(int threads) const { return info().uses_threads ? threads : 1; }
};
INSTANTIATE_TEST_SUITE_P(registry, Conformance, testing::ValuesIn(available_schedulers()),
                         [](const auto& i) { return i.param.name(); });

constexpr Chunk::Unit per_thread = Chunk::Unit::per_thread, bytes = Chunk::Unit::bytes;
const std::vector<Chunk> chunks{
    {1}, {3}, {7}, {16}, {1001}, {max_chunk}, {1, per_thread}, {5, per_thread}, {100, bytes}};

TEST_P(Conformance, every_item_runs_exactly_once) {
  for (const int threads : {1, 2, 3, 4}) {
    const auto scheduler = make(threads);
    for (const size_t count : {0, 1, 7, 1000}) {
      for (const Chunk& chunk : chunks) {
        std::vector<std::atomic<int>> runs(count);
        std::atomic<bool> worker_out_of_range{false};
        WorkerLog log(threads);
        scheduler->run(
            {count}, chunk,
            [&](size_t begin, size_t end, int worker) {
              if (worker < 0 || worker >= workers(threads) || begin >= end) worker_out_of_range = true;
              for (size_t i = begin; i < end; ++i) runs.at(i)++;
            },
            log);
        for (size_t i = 0; i < count; ++i)
          ASSERT_EQ(runs[i], 1) << "item " << i << " of " << count << ", chunk " << chunk.text();
        EXPECT_FALSE(worker_out_of_range);
        size_t logged = 0;
        for (const WorkerEntry& entry : log.entries()) logged += entry.items;
        EXPECT_EQ(logged, count) << "the log counts other items than ran";
      }
    }
  }
}

TEST_P(Conformance, no_worker_runs_two_bodies_at_once) {
  constexpr int threads = 4;
  const auto scheduler = make(threads);
  std::vector<std::atomic<int>> inside(threads);
  std::atomic<bool> overlap{false};
  WorkerLog log(threads);
  const auto body = [&](size_t, size_t, int worker) {
    if (inside[static_cast<size_t>(worker)]++ != 0) overlap = true;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    inside[static_cast<size_t>(worker)]--;
  };
  scheduler->run({100}, {}, body, log);
  EXPECT_FALSE(overlap);
}

/// Each worker waits in its first item until all have come: passes only if as many threads as asked are
/// really there.
TEST_P(Conformance, asked_threads_are_seen_threads) {
  for (const int threads : {1, 2, 3, 4}) {
    const auto scheduler = make(threads);
    const auto wanted = static_cast<size_t>(workers(threads));
    std::mutex mutex;
    std::set<std::thread::id> ids;
    std::set<int> numbers;
    const auto seen = [&] {
      const std::scoped_lock lock(mutex);
      return ids.size();
    };
    const auto give_up = std::chrono::steady_clock::now() + std::chrono::seconds(20);
    WorkerLog log(threads);
    scheduler->run(
        {64}, {},
        [&](size_t, size_t, int worker) {
          {
            const std::scoped_lock lock(mutex);
            ids.insert(std::this_thread::get_id());
            numbers.insert(worker);
          }
          while (seen() < wanted && std::chrono::steady_clock::now() < give_up) std::this_thread::yield();
        },
        log);
    EXPECT_EQ(ids.size(), wanted);
    EXPECT_EQ(numbers.size(), wanted);
    EXPECT_EQ(log.workers_seen(), static_cast<int>(wanted));
  }
}

/// Counts bodies that are still inside.
struct Inside {
  explicit Inside(std::atomic<int>& c) : count(c) { count++; }
  ~Inside() { count--; }
  Inside(const Inside&) = delete;
  Inside& operator=(const Inside&) = delete;
  std::atomic<int>& count;
};

TEST_P(Conformance, the_first_error_reaches_the_caller_after_all_stopped_and_the_next_run_works) {
  for (const int threads : {1, 2, 4}) {
    const auto scheduler = make(threads);
    for (const size_t bad : {0, 11, 19}) {
      WorkerLog log(threads);
      std::atomic<int> running{0};
      const auto body = [&](size_t begin, size_t end, int) {
        const Inside inside(running);
        if (begin <= bad && bad < end) throw std::runtime_error("item " + std::to_string(bad));
        std::this_thread::sleep_for(std::chrono::milliseconds(5));  // still inside when the other throws
      };
      try {
        scheduler->run({20}, {}, body, log);
        ADD_FAILURE() << "nothing was thrown";
      } catch (const std::runtime_error& error) {
        EXPECT_EQ(running, 0) << "the error came before all workers stopped";
        EXPECT_EQ(error.what(), "item " + std::to_string(bad));
      }
      std::atomic<size_t> items{0};
      WorkerLog after(threads);
      scheduler->run(
          {100}, {}, [&](size_t begin, size_t end, int) { items += end - begin; }, after);
      EXPECT_EQ(items, 100u);
    }
  }
}

TEST_P(Conformance, errors_from_all_items_at_once_are_one_error) {
  const auto scheduler = make(4);
  for (int round = 0; round < 50; ++round) {
    WorkerLog log(4);
    EXPECT_THROW(scheduler->run(
                     {64}, {}, [](size_t, size_t, int) { throw std::logic_error("no"); }, log),
                 std::logic_error);
  }
}

TEST_P(Conformance, chunks_are_as_large_as_asked_where_the_scheduler_decides_them) {
  const std::set<std::string> exact{"thread_cyclic", "thread_dynamic", "omp_dynamic"};
  if (!exact.contains(GetParam().scheduler)) return;
  const auto scheduler = make(3);
  std::mutex mutex;
  std::multiset<size_t> sizes;
  WorkerLog log(3);
  scheduler->run(
      {100}, {16},
      [&](size_t begin, size_t end, int) {
        const std::scoped_lock lock(mutex);
        sizes.insert(end - begin);
      },
      log);
  EXPECT_EQ(sizes.count(16), 6u);
  EXPECT_EQ(sizes.count(4), 1u);
}

TEST(thread_chunks, makes_k_near_equal_chunks_for_each_thread) {
  const auto scheduler = make_scheduler("thread_chunks", {.threads = 3});
  std::mutex mutex;
  std::multiset<size_t> sizes;
  WorkerLog log(3);
  scheduler->run(
      {100}, {4},
      [&](size_t begin, size_t end, int) {
        const std::scoped_lock lock(mutex);
        sizes.insert(end - begin);
      },
      log);
  EXPECT_EQ(sizes.size(), 12u);
  EXPECT_EQ(*sizes.begin(), 8u);
  EXPECT_EQ(*sizes.rbegin(), 9u);
}

TEST(chunk, per_thread_chunks_are_at_most_threads_times_k) {
  EXPECT_EQ((Chunk{2, per_thread}.size({100}, 4)), 13u);
  EXPECT_EQ((Chunk{2, per_thread}.size({3}, 4)), 1u);
  EXPECT_EQ((Chunk{5}.size({100}, 4)), 5u);
}

TEST(chunk, bytes_are_as_many_items_as_write_them) {
  EXPECT_EQ((Chunk{4096, bytes}.size({100, 0, 192}, 4)), 21u);
  EXPECT_EQ((Chunk{100, bytes}.size({100, 0, 192}, 4)), 1u);
}

}  // namespace
}  // namespace raysweep
