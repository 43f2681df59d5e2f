#include "experiments/peers/shared_work.h"

#include <gtest/gtest.h>

#include <atomic>
#include <latch>
#include <mutex>
#include <set>
#include <stdexcept>
#include <vector>

namespace raysweep {
namespace {

TEST(shared_work, calls_every_number_once_whatever_the_count_of_threads) {
  for (const int threads : {1, 2, 5}) {
    std::vector<std::atomic<int>> calls(100);
    share_work(threads, calls.size(), [&](size_t i, size_t worker) {
      EXPECT_LT(worker, static_cast<size_t>(threads));
      calls[i]++;
    });
    for (const auto& count : calls) EXPECT_EQ(count, 1);
  }
}

TEST(shared_work, a_team_runs_again_and_again_even_after_an_error) {
  for (const int threads : {1, 2, 5}) {
    WorkTeam team(threads);
    for (size_t count = 0; count < 300; ++count) {
      std::vector<int> calls(count);  // not atomic: each number is one thread's, and then the caller's
      team.run(count, [&](size_t i, size_t) { calls[i]++; });
      EXPECT_EQ(calls, std::vector<int>(count, 1));
      const auto fails = [&](size_t i, size_t) {
        if (i == count / 2) throw std::runtime_error("no");
      };
      if (count > 0) {
        EXPECT_THROW(team.run(count, fails), std::runtime_error);
      }
    }
  }
}

/// A number that no other thread ever gets; ids of threads are used again.
int own_number() {
  static std::atomic<int> count{0};
  thread_local const int number = count++;
  return number;
}

TEST(shared_work, a_team_keeps_its_threads) {
  WorkTeam team(2);
  std::set<int> seen;
  std::mutex mutex;
  for (int run = 0; run < 20; ++run) {
    std::latch both(2);  // so that each of the two has an item
    team.run(2, [&](size_t, size_t) {
      both.arrive_and_wait();
      const std::scoped_lock lock(mutex);
      seen.insert(own_number());
    });
  }
  EXPECT_EQ(seen.size(), 2u);
}

TEST(shared_work, an_error_of_any_worker_comes_back_to_the_caller) {
  for (const int threads : {1, 3}) {
    for (const size_t bad : {0, 7, 99}) {
      const auto body = [&](size_t i, size_t) {
        if (i == bad) throw std::runtime_error("no");
      };
      EXPECT_THROW(share_work(threads, 100, body), std::runtime_error);
    }
  }
}

}  // namespace
}  // namespace raysweep
