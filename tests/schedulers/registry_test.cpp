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
  EXPECT_EQ(names.size(), 13u);
  EXPECT_EQ(find_scheduler("tbbb"), nullptr);
}

TEST(registry, what_was_found_when_building_is_there_and_what_was_not_says_so) {
  EXPECT_EQ(why_unavailable("std"), "");
  const std::pair<const char*, bool> families[] = {{"openmp", RAYSWEEP_HAS_OPENMP},
                                                   {"tbb", RAYSWEEP_HAS_TBB}};
  for (const auto& [family, built] : families) {
    EXPECT_EQ(why_unavailable(family).empty(), built) << why_unavailable(family);
    EXPECT_EQ(runtime_of(family).empty(), !built);
    if (!built) {
      EXPECT_NE(why_unavailable(family).find("not built"), std::string::npos);
    }
  }
}

TEST(registry, refuses_unknown_names_and_impossible_thread_counts) {
  EXPECT_THROW((void)make_scheduler("tbbb", 1), SchedulerError);
  for (const int threads : {0, -1, 1025})
    EXPECT_THROW((void)make_scheduler("thread_static", threads), SchedulerError);
  EXPECT_NO_THROW((void)make_scheduler("thread_static", 1024));
}

}  // namespace
}  // namespace raysweep
