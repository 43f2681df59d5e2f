// Work of several threads, taken in order.
#include "experiments/in_order.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <numeric>
#include <stdexcept>
#include <string>

namespace raysweep {
namespace {

TEST(in_order, every_result_is_taken_once_and_in_order_whatever_ends_first) {
  for (const size_t threads : {1, 2, 7}) {
    std::vector<std::atomic<int>> runs(100);
    std::vector<size_t> taken;
    work_in_order(
        runs.size(), threads,
        [&](size_t i) {
          if (i % 7 == 0) std::this_thread::sleep_for(std::chrono::milliseconds(2));  // overtaken by others
          ++runs[i];
          return 3 * i;
        },
        [&](size_t i, size_t result) {
          EXPECT_EQ(result, 3 * i);
          taken.push_back(i);
          return true;
        });
    std::vector<size_t> all(runs.size());
    std::iota(all.begin(), all.end(), size_t{0});
    EXPECT_EQ(taken, all) << threads;
    EXPECT_TRUE(std::all_of(runs.begin(), runs.end(), [](const auto& count) { return count == 1; }));
  }
}

TEST(in_order, of_nothing_nothing_is_taken) {
  work_in_order(
      0, 3, [](size_t i) { return i; }, [](size_t, size_t) { return ADD_FAILURE(), true; });
}

TEST(in_order, what_take_declines_is_the_last_and_little_is_begun_ahead) {
  std::atomic<size_t> begun = 0;
  size_t taken = 0;
  work_in_order(
      10'000, 2,
      [&](size_t i) {
        ++begun;
        return i;
      },
      [&](size_t i, size_t) {
        ++taken;
        return i < 5;
      });
  EXPECT_EQ(taken, 6u);
  EXPECT_LE(begun, 5u + 8 + 1) << "four a thread";
}

TEST(in_order, the_first_error_of_either_side_arrives_and_nothing_is_taken_after_it) {
  const auto message = [](size_t bad_work, size_t bad_take) -> std::string {
    size_t taken = 0;
    try {
      work_in_order(
          1000, 3,
          [&](size_t i) {
            if (i == bad_work) throw std::runtime_error("work");
            return i;
          },
          [&](size_t i, size_t) {
            if (i == bad_take) throw std::runtime_error("take");
            ++taken;
            return true;
          });
    } catch (const std::runtime_error& error) {
      EXPECT_LE(taken, std::min(bad_work, bad_take));
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(message(50, 1000), "work");
  EXPECT_EQ(message(1000, 50), "take");
  EXPECT_EQ(message(1000, 1000), "");
}

}  // namespace
}  // namespace raysweep
