#include "results/spoilers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "results/suspicions.h"
#include "results/tables/tables.h"
#include "tests/results/make_record.h"

namespace raysweep {
namespace {

/// Seven quiet launches, of which `change` makes some what they should not be.
std::vector<Record> launches(const std::function<void(Record&)>& change) {
  std::vector<Record> records;
  for (int round = 0; round < 7; ++round) {
    Record r = make_record("omp_static", 2, round, 1);
    r.state.other_processors = 0.02;
    r.state.steal_share = 0.001;
    r.state.pressure_share = 0.01;
    r.state.throttled_seconds = r.state.thermal_throttles = 0;
    r.state.spin_before_seconds = 0.1;
    r.state.spin_after_seconds = 0.101;
    change(r);
    records.push_back(r);
  }
  return records;
}

Disturbance disturbance(const std::function<void(Record&)>& change) {
  const auto records = launches(change);
  Rounds rounds;
  for (const Record& r : records) rounds[r.round] = &r;
  return disturbance_of(rounds, usual_spin_seconds(records));
}

using Reasons = std::vector<std::string>;

TEST(spoilers, say_what_else_the_machine_did_and_how_often) {
  EXPECT_EQ(disturbance([](Record&) {}).reasons, Reasons{});
  EXPECT_EQ(disturbance([](Record& r) {
              r.state.other_processors = r.round < 5 ? 0.98 - 0.1 * r.round : 0.1;
            }).reasons,
            Reasons{"beside other load: up to 0.98 processors in 5 of 7 launches"});
  EXPECT_EQ(disturbance([](Record& r) { r.state.steal_share = r.round < 3 ? 0.12 : 0.02; }).reasons,
            Reasons{"steal up to 12 % in 3 of 7 launches"});
  EXPECT_EQ(disturbance([](Record& r) { r.state.throttled_seconds = r.round == 2 ? 0.01 : 0; }).reasons,
            Reasons{"throttled by a quota in 1 of 7 launches"});
  EXPECT_EQ(disturbance([](Record& r) { r.state.thermal_throttles = r.round; }).reasons,
            Reasons{"throttled because it was hot in 6 of 7 launches"});
  EXPECT_EQ(disturbance([](Record& r) {
              if (r.round < 2) r.state.spin_after_seconds = 0.1085;
            }).reasons,
            Reasons{"the processor ran up to 8 % slower in 2 of 7 launches"});
  EXPECT_EQ(disturbance([](Record& r) { r.warm = r.round > 2; }).reasons,
            Reasons{"not warm when timing began (3 of 7 launches)"});
}

TEST(spoilers, what_single_launches_show_on_any_machine_is_no_reason) {
  EXPECT_EQ(disturbance([](Record& r) { r.warm = r.round > 0; }).reasons, Reasons{});
  const Disturbance slow = disturbance([](Record& r) {
    if (r.round == 0) r.state.spin_after_seconds = 0.2;
  });
  EXPECT_EQ(slow.reasons, Reasons{});
  EXPECT_GT(*slow.spin_excess, 0.9) << "it stands in the data all the same";
}

TEST(spoilers, pressure_is_known_and_no_reason) {
  const Disturbance d = disturbance([](Record& r) { r.state.pressure_share = 0.1 * r.round; });
  EXPECT_TRUE(d.reasons.empty());
  EXPECT_NEAR(*d.pressure_share, 0.6, 1e-12);
}

TEST(spoilers, what_a_machine_does_not_tell_spoils_nothing) {
  const Disturbance d = disturbance([](Record& r) { r.state = {}; });
  EXPECT_TRUE(d.reasons.empty());
  EXPECT_FALSE(d.other_processors);
  EXPECT_FALSE(d.spin_excess);
}

/// A row with this speedup in seven rounds, against serial.
CellRow row_with(int threads, double speedup, int pus = 4) {
  std::vector<Record> records;
  for (int round = 0; round < 7; ++round) {
    records.push_back(make_record("serial", 1, round, 1 + 0.001 * round));
    records.push_back(make_record("omp_static", threads, round, 1 / speedup));
  }
  for (Record& r : records) r.machine = {"host", "cpu", pus, 2, 0};
  return summarise(records, {records[1]}, 0.5).at(0);
}

bool is_suspicious(const CellRow& row, const std::string& what) {
  return std::ranges::any_of(row.notes,
                             [&](const auto& note) { return note.starts_with("suspicious: " + what); });
}

TEST(suspicions, superlinear_rows_are_told) {
  EXPECT_TRUE(is_suspicious(row_with(2, 2.2), "superlinear"));
  EXPECT_FALSE(is_suspicious(row_with(2, 2.08), "superlinear"));
  EXPECT_FALSE(is_suspicious(row_with(4, 2.6), "superlinear")) << "two cores have four hardware threads";
  EXPECT_TRUE(is_suspicious(row_with(4, 2.6, 2), "superlinear")) << "two processors";
}

TEST(suspicions, one_thread_faster_than_serial_is_told) {
  EXPECT_TRUE(is_suspicious(row_with(1, 1.02), "faster than serial"));
  EXPECT_FALSE(is_suspicious(row_with(1, 0.99), "faster than serial"));
  CellRow row = row_with(1, 1.02);
  EXPECT_TRUE(suspicions(row, {0.03, 7}).empty()) << "below the noise floor";
  EXPECT_EQ(suspicions(row, {0.01, 7}).size(), 1u);
  row.speedup->interval.reset();
  EXPECT_TRUE(suspicions(row, {}).empty()) << "no interval";
}

TEST(spoilers, stand_among_the_notes_of_a_row) {
  const auto records = launches([](Record& r) {
    r.state.steal_share = 0.05;
    r.warm = false;
  });
  const auto rows = summarise(records, {records[0]}, 0.5);
  EXPECT_EQ(rows[0].notes,
            (Reasons{"not warm when timing began (7 of 7 launches)", "steal up to 5 % in 7 of 7 launches"}));
  const Table data = scaling_data(rows);
  const auto column = std::ranges::find(data.columns, "steal_share", &Table::Column::title);
  EXPECT_EQ(data.rows[0][static_cast<size_t>(column - data.columns.begin())], "0.05");
}

}  // namespace
}  // namespace raysweep
