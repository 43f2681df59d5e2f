#include "schedulers/registry.h"

#include <gtest/gtest.h>

#include <set>

namespace raysweep {
namespace {

TEST(registry, names_are_unique_and_found) {
  std::set<std::string_view> names;
  for (const SchedulerInfo& info : all_schedulers()) {
    EXPECT_TRUE(names.insert(info.name).second) << info.name;
    EXPECT_EQ(find_scheduler(info.name), &info);
  }
  EXPECT_EQ(names.size(), 21u);
  EXPECT_EQ(find_scheduler("tbbb"), nullptr);
}

TEST(registry, what_was_found_when_building_is_there_and_what_was_not_says_so) {
  const std::pair<const char*, bool> runtimes[] = {
      {"libgomp", RAYSWEEP_HAS_LIBGOMP}, {"libomp", RAYSWEEP_HAS_LIBOMP}, {"tbb", RAYSWEEP_HAS_TBB}};
  EXPECT_EQ(std::size(runtimes), all_runtimes().size());
  for (const auto& [runtime, built] : runtimes) {
    const ModuleReport& report = module_report(runtime);
    EXPECT_EQ(report.problem.empty(), built) << report.problem;
    if (built) {
      EXPECT_NE(report.library.file.find(runtime), std::string::npos) << report.library.file;
      EXPECT_GE(report.library.build_id.size(), 16u);
    } else {
      EXPECT_NE(report.problem.find("not built"), std::string::npos);
    }
  }
}

TEST(registry, refuses_unknown_names_and_impossible_options) {
  EXPECT_THROW((void)make_scheduler("tbbb", {}), SchedulerError);
  for (const int threads : {0, -1, 1025})
    EXPECT_THROW((void)make_scheduler("thread_static", {.threads = threads}), SchedulerError);
  EXPECT_THROW((void)make_scheduler("thread_static", {.threads = 1, .processors = {1 << 20}}),
               SchedulerError);
  EXPECT_NO_THROW((void)make_scheduler("thread_static", {.threads = 1024}));
}

}  // namespace
}  // namespace raysweep
