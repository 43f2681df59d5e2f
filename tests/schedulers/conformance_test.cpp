// What every scheduler promises, over the whole registry.
#include "tests/schedulers/conformance.h"

#include <mutex>
#include <set>

namespace raysweep {
namespace {

INSTANTIATE_TEST_SUITE_P(registry, Conformance, testing::ValuesIn(available_schedulers()),
                         [](const auto& i) { return i.param.name(); });

TEST_P(Conformance, every_item_runs_exactly_once) {
  expect_every_item_runs_exactly_once(factory(), info().uses_threads);
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

constexpr Chunk::Unit per_thread = Chunk::Unit::per_thread, bytes = Chunk::Unit::bytes;

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
