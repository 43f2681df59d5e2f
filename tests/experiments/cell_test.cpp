#include "experiments/cell.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "experiments/cell_factors.h"
#include "experiments/errors.h"
#include "tracer/wide/isa.h"

namespace raysweep {
namespace {

std::string problem(const char* factor, const std::string& value) {
  Cell cell;
  return find_factor(factor)->set(cell, value);
}

TEST(cell, goes_to_a_launch_and_comes_back) {
  Cell cell;
  set_mode(cell, "very_hard");
  set_factor(cell, *find_factor("scheduler"), "thread_chunks");
  set_factor(cell, *find_factor("chunk"), "3/thread");
  set_factor(cell, *find_factor("threads"), "5");
  set_factor(cell, *find_factor("item"), "tiles:32");
  cell.processes = 2;
  const Cell back = cell_from_json(to_json(cell));
  EXPECT_EQ(back.key(), cell.key());
  EXPECT_EQ(back.settings.width, 1920);
  EXPECT_EQ(back.lights, 2);
}

TEST(cell, every_factor_is_in_the_key) {
  const std::pair<const char*, const char*> others[] = {{"scene", "studio"},
                                                        {"width", "7"},
                                                        {"height", "7"},
                                                        {"subpixels", "7"},
                                                        {"pattern", "circle:0.25:0.5"},
                                                        {"depth", "7"},
                                                        {"lights", "7"},
                                                        {"pixel_tolerance", "0.01"},
                                                        {"branches", "7"},
                                                        {"accel", "none"},
                                                        {"leaf", "7"},
                                                        {"core", "m11"},
                                                        {"method", "morozov"},
                                                        {"precision", "double"},
                                                        {"threads", "7"},
                                                        {"item", "tiles"},
                                                        {"chunk", "7"},
                                                        {"scheduler", "thread_cyclic"},
                                                        {"order", "hilbert"},
                                                        {"pin", "cores"},
                                                        {"wait_policy", "passive"},
                                                        {"spin_count", "7"},
                                                        {"environment", "OMP_PLACES=cores"},
                                                        {"slowdown", "0.05"}};
  EXPECT_EQ(std::size(others) + 2, cell_factors().size())
      << "runtime is for OpenMP alone, isa for the core wide";
  for (const auto& [name, value] : others) {
    Cell a, b;
    // std::thread reads no environment; TBB's schedulers have no say in how they wait.
    a.scheduler = b.scheduler = std::string(name) == "environment" ? "tbb_auto" : "thread_dynamic";
    set_factor(b, *find_factor(name), value);
    EXPECT_NE(a.key(), b.key()) << name;
  }
}

TEST(cell, the_instruction_set_tells_cells_of_the_core_wide_apart_and_no_others) {
  Cell best, other;
  for (Cell* cell : {&best, &other}) set_factor(*cell, *find_factor("core"), "wide");
  const std::string last(built_isas().back().name);
  if (last == best_isa()) GTEST_SKIP() << "there is one only";
  set_factor(other, *find_factor("isa"), last);
  EXPECT_EQ(best.isa_text(), best_isa());
  EXPECT_NE(best.key(), other.key());
  Cell named = best;
  set_factor(named, *find_factor("isa"), std::string(best_isa()));
  EXPECT_EQ(named.key(), best.key()) << "best is the name of what is used";
  for (Cell* cell : {&best, &other}) {
    set_factor(*cell, *find_factor("core"), "scalar");
    collapse_ignored_factors(*cell);
  }
  EXPECT_EQ(best.key(), other.key());
  EXPECT_EQ(best.isa_text(), "baseline");
}

TEST(cell, an_instruction_set_that_is_not_here_is_refused_by_name) {
  Cell cell;
  try {
    set_factor(cell, *find_factor("isa"), "mmx");
    FAIL();
  } catch (const RequestError& e) {
    EXPECT_EQ(std::string(e.what()).find("isa \"mmx\" cannot be used here; possible: best, "), 0u)
        << e.what();
  }
}

TEST(cell, the_core_wide_refuses_other_precisions_than_float) {
  Cell cell;
  set_factor(cell, *find_factor("core"), "wide");
  refuse_impossible(cell);
  set_factor(cell, *find_factor("precision"), "double");
  EXPECT_THROW(refuse_impossible(cell), RequestError);
  set_factor(cell, *find_factor("core"), "m11");
  refuse_impossible(cell);
}

TEST(cell, ignored_factors_collapse) {
  Cell a, b;
  b.threads = 5;
  b.chunk.value = 9;
  collapse_ignored_factors(b);
  EXPECT_EQ(a.key(), b.key()) << "serial has neither threads nor chunks";
}

TEST(cell, pictures_do_not_depend_on_scheduling_or_hierarchy) {
  Cell a, b;
  b.scheduler = "thread_static";
  b.threads = 4;
  b.item = "tiles";
  b.settings.accel = "median";
  b.settings.leaf = 64;
  EXPECT_EQ(a.picture_key(), b.picture_key());
  b.settings.core = "m11";
  EXPECT_NE(a.picture_key(), b.picture_key());
}

TEST(factors, refuse_by_a_sentence_with_what_is_possible) {
  EXPECT_EQ(problem("threads", "0"),
            "threads = 0 is out of range: a whole number from 1 to 1024 is possible");
  EXPECT_EQ(problem("threads", "-1"),
            "threads = -1 is out of range: a whole number from 1 to 1024 is possible");
  EXPECT_EQ(problem("threads", "1000000000"),
            "threads = 1000000000 is out of range: a whole number from 1 to 1024 is possible");
  EXPECT_EQ(problem("threads", "99999999999999999999"),
            "threads = 99999999999999999999 is not a whole number in range: a whole number from 1 to 1024 is "
            "possible");
  EXPECT_EQ(problem("width", "0"), "width = 0 is out of range: a whole number from 1 to 32768 is possible");
  EXPECT_EQ(problem("depth", "4x"),
            "depth = 4x is not a whole number in range: a whole number from 1 to 1024 is possible");
  EXPECT_EQ(problem("accel", "kd"), "unknown accel \"kd\"; possible: sah, sbvh, median, none");
  EXPECT_EQ(problem("pattern", "ring"),
            "unknown pattern \"ring\"; possible: grid, rotated_grid, circle, circle:RADIUS, "
            "circle:RADIUS:PHASE, halton, sobol, sobol:SEED");
  EXPECT_EQ(problem("pattern", "circle:0.7"),
            "circle:0.7: the radius must be above 0 and at most 0.5 pixels");
  EXPECT_EQ(problem("item", "tiles:0"),
            "unknown item \"tiles:0\"; possible: pixels, rows, columns, tiles, tiles:SIDE with a side from 1 "
            "to 1024");
  EXPECT_EQ(problem("chunk", "0"),
            "chunk = 0 is not possible: a count from 1 to 16777216, \"COUNT/thread\", or \"COUNTB\" for "
            "bytes of film");
  EXPECT_EQ(problem("pin", "spread"),
            "unknown pin \"spread\"; possible: none, cores, compact, scatter, one_core, or a list of "
            "processors such "
            "as 0,2,4-7");
  EXPECT_EQ(problem("runtime", "gomp"), "unknown runtime \"gomp\"; possible: default, libgomp, libomp");
  EXPECT_EQ(problem("order", "random"), "unknown order \"random\"; possible: scanline, morton, hilbert, lpt");
  EXPECT_EQ(problem("spin_count", "-1"),
            "spin_count = -1 is out of range: a whole number from 0 to 1000000000 is possible");
  EXPECT_EQ(
      problem("environment", "KMP_BLOCKTIME=0 OMP_WAIT_POLICY=active"),
      "environment = \"KMP_BLOCKTIME=0 OMP_WAIT_POLICY=active\": OMP_WAIT_POLICY has a factor of its own: "
      "wait_policy");
  EXPECT_EQ(problem("environment", "PATH=/tmp"),
            "environment = \"PATH=/tmp\" is not possible: NAME=VALUE, separated by spaces, with names that "
            "begin with "
            "OMP_, GOMP_, KMP_, TBB_");
  EXPECT_TRUE(problem("scheduler", "tbbb")
                  .starts_with("unknown scheduler \"tbbb\"; built here: serial, thread_static"));
}

TEST(modes, are_the_published_ones) {
  EXPECT_THROW(
      {
        Cell cell;
        set_mode(cell, "easy");
      },
      RequestError);
  Cell cell;
  set_mode(cell, "hard");
  EXPECT_EQ(cell.settings.width, 1024);
  EXPECT_EQ(cell.settings.height, 768);
  EXPECT_EQ(cell.settings.subpixels, 3);
  EXPECT_EQ(cell.settings.depth, 4);
  EXPECT_EQ(cell.lights, 2);
}

}  // namespace
}  // namespace raysweep
