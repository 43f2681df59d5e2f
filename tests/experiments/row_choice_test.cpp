#include "experiments/row_choice.h"

#include <gtest/gtest.h>

#include "experiments/errors.h"
#include "tests/results/make_record.h"

namespace raysweep {
namespace {

std::vector<CellRow> three_rows() {
  std::vector<CellRow> rows;
  for (const auto& [scheduler, threads] : {std::pair("serial", 1), {"omp_static", 1}, {"omp_static", 2}}) {
    CellRow row;
    row.cell = make_record(scheduler, threads, 0, 1);
    rows.push_back(row);
  }
  return rows;
}

std::string refusal(const std::string& text) {
  const auto rows = three_rows();
  try {
    (void)choose_row(rows, text);
    return "";
  } catch (const RequestError& error) {
    return error.what();
  }
}

TEST(row_choice, as_few_factors_as_tell_it_apart) {
  const auto rows = three_rows();
  EXPECT_EQ(&choose_row(rows, "scheduler=serial"), &rows[0]);
  EXPECT_EQ(&choose_row(rows, "threads=2"), &rows[2]);
  EXPECT_EQ(&choose_row(rows, "scheduler=omp_static,threads=1"), &rows[1]);
}

TEST(row_choice, what_a_scheduler_has_no_use_for_tells_nobody_apart) {
  auto rows = three_rows();
  rows[0].cell.runtime.assign(1, '-');
  rows[1].cell.runtime = rows[2].cell.runtime = "libgomp";
  try {
    (void)choose_row(rows, "item=rows");
    FAIL();
  } catch (const RequestError& error) {
    EXPECT_EQ(std::string(error.what()).find("runtime"), std::string::npos) << error.what();
  }
}

TEST(row_choice, a_list_of_processors_holds_commas) {
  auto rows = three_rows();
  rows[1].cell.pin = "0,1";
  rows[2].cell.pin = "0,2";
  EXPECT_EQ(&choose_row(rows, "pin=0,2,scheduler=omp_static"), &rows[2]);
}

TEST(row_choice, what_is_wrong_is_told_with_what_is_possible) {
  EXPECT_EQ(refusal("scheduler=omp_static"),
            "--cell scheduler=omp_static: 2 cells are meant; name one by threads (1, 2)");
  EXPECT_EQ(refusal("scheduler=omp_static,threads=3"),
            "--cell scheduler=omp_static,threads=3: no cell has threads=3; there is threads = 1, 2");
  EXPECT_NE(refusal("colour=red").find("unknown factor \"colour\"; possible: scene, mode, "),
            std::string::npos);
  EXPECT_EQ(refusal("threads"),
            "--cell threads: \"threads\" is no condition; write FACTOR=VALUE,FACTOR=VALUE");
}

}  // namespace
}  // namespace raysweep
