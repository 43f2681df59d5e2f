// Workers run where they were bound to, and nothing stays bound afterwards, over the whole registry.
#include <sched.h>

#include <algorithm>
#include <mutex>
#include <set>

#include "tests/schedulers/conformance.h"

namespace raysweep {
namespace {

class Pinning : public Conformance {
 public:
  static constexpr int asked_threads = 4;
  [[nodiscard]] int threads() const { return workers(asked_threads); }
  [[nodiscard]] std::unique_ptr<Scheduler> make_on(const std::vector<int>& processors) const {
    return make(SchedulerOptions{.threads = threads(), .processors = processors});
  }
};
INSTANTIATE_TEST_SUITE_P(registry, Pinning, testing::ValuesIn(available_schedulers()),
                         [](const auto& i) { return i.param.name(); });

/// All processors that are allowed, in both directions, and the last one alone.
std::vector<std::vector<int>> placements() {
  const ProcessorSet there = allowed_processors();
  return {there, {there.rbegin(), there.rend()}, {there.back()}};
}

/// On which processors each worker's bodies ran in one run in which all workers took part.
std::vector<std::set<int>> processors_of_bodies(Scheduler& scheduler, int threads) {
  std::vector<std::set<int>> seen(static_cast<size_t>(threads));
  Meeting meeting(threads);
  WorkerLog log(threads);
  const auto body = [&](size_t, size_t, int worker) {
    seen[static_cast<size_t>(worker)].insert(sched_getcpu());
    meeting.first_of(worker);
    seen[static_cast<size_t>(worker)].insert(sched_getcpu());
  };
  scheduler.run({static_cast<size_t>(threads) * 16}, {}, body, log);
  EXPECT_TRUE(meeting.complete());
  return seen;
}

TEST_P(Pinning, each_worker_may_and_does_run_on_its_processor_alone) {
  for (const std::vector<int>& asked : placements()) {
    const auto scheduler = make_on(asked);
    const auto told = processors_of_workers(*scheduler, threads());
    const auto seen = processors_of_bodies(*scheduler, threads());
    for (size_t worker = 0; worker < told.size(); ++worker) {
      const int processor = asked[worker % asked.size()];
      EXPECT_EQ(told[worker], ProcessorSet{processor}) << "worker " << worker;
      EXPECT_EQ(seen[worker], std::set<int>{processor}) << "worker " << worker;
    }
  }
}

TEST_P(Pinning, the_caller_gets_its_processors_back) {
  const ProcessorSet before = allowed_processors();
  for (const std::vector<int>& asked : placements()) {
    {
      const auto scheduler = make_on(asked);
      for (int run = 0; run < 3; ++run) {
        (void)processors_of_bodies(*scheduler, threads());
        // Gotcha 20: TBB's observers fire for the calling thread too, which is a worker only inside a run.
        if (info().family == "tbb") {
          EXPECT_EQ(allowed_processors(), before) << "between runs";
        }
      }
    }
    EXPECT_EQ(allowed_processors(), before) << "after the scheduler's end";
  }
}

/// Runtimes keep their threads for the next scheduler, which did not ask for their former processors.
TEST_P(Pinning, an_unbound_scheduler_after_a_bound_one_may_run_anywhere) {
  const ProcessorSet all = allowed_processors();
  for (int round = 0; round < unless_sanitized(50, 5); ++round) {
    (void)processors_of_bodies(*make_on({all.back()}), threads());
    const auto scheduler = make(threads());
    for (const ProcessorSet& told : processors_of_workers(*scheduler, threads()))
      ASSERT_EQ(told, all) << "round " << round;
  }
}

/// The same, where nobody waits for the workers of the bound one to leave.
TEST_P(Pinning, another_placement_after_a_bound_one_is_the_other_one) {
  const ProcessorSet all = allowed_processors();
  for (int round = 0; round < unless_sanitized(20, 5); ++round) {
    const int processor = all[static_cast<size_t>(round) % all.size()];
    const auto scheduler = make_on({processor});
    for (const ProcessorSet& told : processors_of_workers(*scheduler, threads()))
      ASSERT_EQ(told, ProcessorSet{processor}) << "round " << round;
  }
}

}  // namespace
}  // namespace raysweep
