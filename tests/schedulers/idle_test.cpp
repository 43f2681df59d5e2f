// Idle workers sleep, so that runtimes do not disturb each other, over the whole registry.
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "tests/schedulers/conformance.h"

namespace raysweep {
namespace {

class Idle : public Conformance {};
INSTANTIATE_TEST_SUITE_P(registry, Idle, testing::ValuesIn(available_schedulers()),
                         [](const auto& i) { return i.param.name(); });

/// States of all threads of this process but the calling one, as the kernel's letters: 'S' sleeps, 'R' runs
/// or would like to.
std::string states_of_others() {
  std::string states;
  for (const auto& task : std::filesystem::directory_iterator("/proc/self/task")) {
    if (task.path().filename() == std::to_string(gettid())) continue;
    std::ifstream in(task.path() / "stat");
    std::string line;
    std::getline(in, line);
    const size_t name_end = line.rfind(')');  // the name before it may hold anything
    if (name_end != std::string::npos) states += line.at(name_end + 2);
  }
  return states;
}

/// Whether the others sleep, ten looks in a row. Gives up after 5 s: libomp's workers wait 200 ms first, and
/// a busy machine lets them come to their sleep late.
bool others_fall_asleep() {
  const auto give_up = std::chrono::steady_clock::now() + std::chrono::seconds(5);
  for (int asleep = 0; asleep < 10;) {
    if (std::chrono::steady_clock::now() > give_up) return false;
    asleep = states_of_others().find_first_not_of('S') == std::string::npos ? asleep + 1 : 0;
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  return true;
}

void expect_sleep_after_a_run(Scheduler& scheduler, int workers) {
  Meeting meeting(workers);  // all have been awake
  WorkerLog log(workers);
  scheduler.run(
      {64}, {}, [&](size_t, size_t, int worker) { meeting.first_of(worker); }, log);
  EXPECT_TRUE(meeting.complete());
  EXPECT_TRUE(others_fall_asleep()) << states_of_others();
}

TEST_P(Idle, workers_fall_asleep_after_a_run) {
  const int threads = workers(2);
  const auto scheduler = make(threads);
  expect_sleep_after_a_run(*scheduler, threads);
}

TEST_P(Idle, passive_workers_fall_asleep_after_a_run) {
  const int threads = workers(2);
  try {
    const auto scheduler = make(SchedulerOptions{.threads = threads, .wait = WaitPolicy::passive});
    expect_sleep_after_a_run(*scheduler, threads);
  } catch (const SchedulerError& error) {
    // All tests in one process: another one loaded the runtime first. By ctest that is never so.
    if (std::string(error.what()).find("with another wait policy") == std::string::npos) throw;
    GTEST_SKIP() << error.what();
  }
}

/// The test above can tell: a worker that spins is seen.
TEST(idle, active_workers_are_seen_awake) {
  const auto scheduler =
      make_scheduler("thread_static", {.threads = 2, .wait = WaitPolicy::active, .spin_count = {}});
  EXPECT_NE(states_of_others().find('R'), std::string::npos) << states_of_others();
}

}  // namespace
}  // namespace raysweep
