#include "tests/schedulers/conformance.h"

#include <stdexcept>

namespace raysweep {

namespace {

constexpr Chunk::Unit per_thread = Chunk::Unit::per_thread, bytes = Chunk::Unit::bytes;
const std::vector<Chunk> chunks{
    {1}, {3}, {7}, {16}, {1001}, {max_chunk}, {1, per_thread}, {5, per_thread}, {100, bytes}};

void expect_every_item_once(Scheduler& scheduler, size_t count, const Chunk& chunk, int threads,
                            int workers) {
  std::vector<std::atomic<int>> runs(count);
  std::atomic<bool> worker_out_of_range{false};
  WorkerLog log(threads);
  const auto body = [&](size_t begin, size_t end, int worker) {
    if (worker < 0 || worker >= workers || begin >= end) worker_out_of_range = true;
    for (size_t i = begin; i < end; ++i) runs.at(i)++;
  };
  scheduler.run({count}, chunk, body, log);
  for (size_t i = 0; i < count; ++i)
    ASSERT_EQ(runs[i], 1) << "item " << i << " of " << count << ", chunk " << chunk.text();
  EXPECT_FALSE(worker_out_of_range);
  size_t logged = 0;
  for (const WorkerEntry& entry : log.entries()) logged += entry.items;
  EXPECT_EQ(logged, count) << "the log counts other items than ran";
}

/// Counts bodies that are still inside.
struct Inside {
  explicit Inside(std::atomic<int>& c) : count(c) { count++; }
  ~Inside() { count--; }
  Inside(const Inside&) = delete;
  Inside& operator=(const Inside&) = delete;
  std::atomic<int>& count;
};

void expect_the_error_of_item(size_t bad, Scheduler& scheduler, int threads) {
  WorkerLog log(threads);
  std::atomic<int> running{0};
  const auto body = [&](size_t begin, size_t end, int) {
    const Inside inside(running);
    if (begin <= bad && bad < end) throw std::runtime_error("item " + std::to_string(bad));
    std::this_thread::sleep_for(std::chrono::milliseconds(5));  // still inside when the other throws
  };
  try {
    scheduler.run({20}, {}, body, log);
    ADD_FAILURE() << "nothing was thrown";
  } catch (const std::runtime_error& error) {
    EXPECT_EQ(running, 0) << "the error came before all workers stopped";
    EXPECT_EQ(error.what(), "item " + std::to_string(bad));
  }
}

}  // namespace

void expect_every_item_runs_exactly_once(const Factory& make, bool uses_threads) {
  for (const int threads : {1, 2, 3, 4}) {
    const auto scheduler = make(threads);
    for (const size_t count : {0, 1, 7, 1000}) {
      for (const Chunk& chunk : chunks)
        expect_every_item_once(*scheduler, count, chunk, threads, uses_threads ? threads : 1);
    }
  }
}

void expect_the_first_error_reaches_the_caller(const Factory& make) {
  for (const int threads : {1, 2, 4}) {
    const auto scheduler = make(threads);
    for (const size_t bad : {0, 11, 19}) {
      expect_the_error_of_item(bad, *scheduler, threads);
      std::atomic<size_t> items{0};
      WorkerLog log(threads);
      scheduler->run(
          {100}, {}, [&](size_t begin, size_t end, int) { items += end - begin; }, log);
      EXPECT_EQ(items, 100u);
    }
  }
}

}  // namespace raysweep
