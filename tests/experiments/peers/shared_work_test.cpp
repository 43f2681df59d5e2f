#include "experiments/peers/shared_work.h"

#include <gtest/gtest.h>

#include <atomic>
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
