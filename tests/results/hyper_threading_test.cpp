#include "results/hyper_threading.h"

#include <gtest/gtest.h>

#include "results/tables/tables.h"
#include "tests/results/make_record.h"

namespace raysweep {
namespace {

/// Where `threads` threads of a cell ran.
struct Placed {
  std::string pin;
  int threads, cores;
  std::vector<int> processors;
  double fps;
  std::string mode = "hard";
};

/// Four cores; the processors of a core are neighbours.
const Placed one_each{"0,2,4,6", 4, 4, {0, 2, 4, 6}, 4}, two_each{"0-7", 8, 4, {0, 1, 2, 3, 4, 5, 6, 7}, 5},
    packed{"0-3", 4, 2, {0, 1, 2, 3}, 2.5};

std::vector<CellRow> rows_of(const std::vector<Placed>& cells, int rounds = 7) {
  std::vector<Record> records, planned;
  for (int round = 0; round < rounds; ++round) {
    const double slow = 1 + 0.1 * round;
    records.push_back(make_record("serial", 1, round, slow));
    records.back().pin = "-";
    for (const Placed& p : cells) {
      Record r = make_record("thread_dynamic", p.threads, round, slow / p.fps);
      r.pin = p.pin;
      r.mode = p.mode;
      r.cell += p.pin;
      r.machine = {"host", "cpu", 8, 4, 0};
      r.cores_seen = p.cores;
      r.processors_seen = static_cast<int>(p.processors.size());
      for (const int processor : p.processors) r.workers.push_back({.cpu = processor});
      records.push_back(r);
    }
  }
  for (const Record& r : records) {
    if (r.round == 0) planned.push_back(r);
  }
  return summarise(records, planned, 0.5);
}

TEST(hyper_threading, yield_and_packing_penalty_are_paired_within_rounds) {
  const auto rows = rows_of({one_each, two_each, packed});
  const auto groups = hyper_threading_groups(rows);
  ASSERT_EQ(groups.size(), 1u);
  EXPECT_EQ(groups[0].cores(), 4);
  EXPECT_NEAR(groups[0].yield->value, 1.25, 1e-12);
  EXPECT_NEAR(groups[0].yield->interval->low, 1.25, 1e-12) << "drift must cancel";
  EXPECT_NEAR(groups[0].packing_penalty->value, 0.625, 1e-12);
}

TEST(hyper_threading, efficiencies_are_by_the_cores_and_hardware_threads_that_ran) {
  const auto rows = rows_of({one_each, two_each, packed});
  const HyperThreadingGroup group = hyper_threading_groups(rows).at(0);
  EXPECT_NEAR(*group.one_each->core_efficiency, 1, 1e-12);
  EXPECT_NEAR(*hardware_thread_efficiency(*group.one_each), 1, 1e-12);
  EXPECT_NEAR(*group.two_each->core_efficiency, 5.0 / 4, 1e-12);
  EXPECT_NEAR(*hardware_thread_efficiency(*group.two_each), 5.0 / 8, 1e-12);
  EXPECT_NEAR(*group.packed->core_efficiency, 2.5 / 2, 1e-12) << "two cores, though the machine has four";
  EXPECT_NEAR(*hardware_thread_efficiency(*group.packed), 2.5 / 4, 1e-12);
}

TEST(hyper_threading, says_in_words_what_was_shown) {
  const auto words = [](double yield, int rounds = 7) {
    Placed two = two_each;
    two.fps = one_each.fps * yield;
    const auto rows = rows_of({one_each, two, packed}, rounds);
    return hyper_threading_table(rows, hyper_threading_groups(rows)).rows.at(1).back();
  };
  EXPECT_EQ(words(1.25), "yield: a second hardware thread adds 25 % [25, 25]");
  EXPECT_EQ(words(1.042), "yield: a second hardware thread adds 4.2 % [4.2, 4.2]");
  EXPECT_EQ(words(0.75), "yield: a second hardware thread takes 25 % [25, 25]");
  EXPECT_EQ(words(1), "no difference shown");
  EXPECT_EQ(words(1.25, 5), "no interval: fewer than 6 launches");
}

TEST(hyper_threading, needs_both_placements_on_the_same_cores) {
  EXPECT_TRUE(hyper_threading_groups(rows_of({two_each, packed})).empty());
  EXPECT_TRUE(hyper_threading_groups(rows_of({one_each, packed})).empty());
  Placed elsewhere = one_each;
  elsewhere.processors = {8, 10, 12, 14};
  EXPECT_TRUE(hyper_threading_groups(rows_of({elsewhere, two_each})).empty());
  Placed other_picture = one_each;
  other_picture.mode = "low";
  EXPECT_TRUE(hyper_threading_groups(rows_of({other_picture, two_each})).empty());
  Placed unbound = two_each;
  unbound.pin = "none";
  EXPECT_TRUE(hyper_threading_groups(rows_of({one_each, unbound})).empty());
}

TEST(hyper_threading, a_core_alone_has_a_yield_and_no_half) {
  const auto rows = rows_of({{"0", 1, 1, {0}, 1}, {"0-1", 2, 1, {0, 1}, 1.3}});
  const auto groups = hyper_threading_groups(rows);
  ASSERT_EQ(groups.size(), 1u);
  EXPECT_NEAR(groups[0].yield->value, 1.3, 1e-12);
  EXPECT_EQ(groups[0].packed, nullptr);
  EXPECT_FALSE(groups[0].packing_penalty);
  EXPECT_EQ(hyper_threading_table(rows, groups).rows.size(), 2u);
  EXPECT_EQ(hyper_threading_data(groups).rows[0].size(), hyper_threading_data(groups).columns.size());
}

TEST(hyper_threading, is_shown_only_where_a_run_has_such_cells) {
  const auto shown = [](const std::vector<CellRow>& rows) {
    return tables_as_text(rows, {"test", "title"}).find("Hyper-threading") != std::string::npos;
  };
  EXPECT_TRUE(shown(rows_of({one_each, two_each, packed})));
  EXPECT_FALSE(shown(rows_of({one_each, packed})));
}

}  // namespace
}  // namespace raysweep
