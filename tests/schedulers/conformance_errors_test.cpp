// What comes of bodies that throw, over the whole registry.
#include <stdexcept>

#include "tests/schedulers/conformance.h"

namespace raysweep {
namespace {

class Errors : public Conformance {};
INSTANTIATE_TEST_SUITE_P(registry, Errors, testing::ValuesIn(available_schedulers()),
                         [](const auto& i) { return i.param.name(); });

TEST_P(Errors, the_first_error_reaches_the_caller_after_all_stopped_and_the_next_run_works) {
  expect_the_first_error_reaches_the_caller(factory());
}

TEST_P(Errors, errors_from_all_items_are_one_error) {
  const auto scheduler = make(4);
  for (int round = 0; round < 50; ++round) {
    WorkerLog log(4);
    EXPECT_THROW(scheduler->run(
                     {64}, {}, [](size_t, size_t, int) { throw std::logic_error("no"); }, log),
                 std::logic_error);
  }
}

/// Nobody throws before all have come, so that all throw at once: one error arrives, and it is one of theirs.
TEST_P(Errors, errors_of_several_workers_at_once_are_one_error_and_the_next_run_works) {
  for (const int threads : {2, 4}) {
    const auto scheduler = make(threads);
    for (int round = 0; round < 5; ++round) {
      Meeting meeting(workers(threads));
      std::atomic<int> thrown{0}, arrived{0};
      WorkerLog log(threads);
      const auto body = [&](size_t, size_t, int worker) {
        if (!meeting.first_of(worker)) return;
        thrown++;
        throw std::runtime_error("worker " + std::to_string(worker));
      };
      try {
        scheduler->run({64}, {}, body, log);
      } catch (const std::runtime_error& error) {
        arrived++;
        EXPECT_TRUE(std::string(error.what()).starts_with("worker ")) << error.what();
      }
      EXPECT_EQ(thrown, workers(threads)) << "not all workers came";
      EXPECT_EQ(arrived, 1);
      std::atomic<size_t> items{0};
      WorkerLog after(threads);
      scheduler->run(
          {100}, {}, [&](size_t begin, size_t end, int) { items += end - begin; }, after);
      EXPECT_EQ(items, 100u) << "after the error";
    }
  }
}

}  // namespace
}  // namespace raysweep
