#include "experiments/config.h"

#include <gtest/gtest.h>

#include "experiments/errors.h"
#include "tracer/wide/isa.h"

namespace raysweep {
namespace {

constexpr MachineSize machine{6, 12};

Config parse(const std::string& text, const std::vector<std::string>& overrides = {}) {
  return parse_config(text, "sweep.toml", overrides, machine);
}

std::string errors(const std::string& text, const std::vector<std::string>& overrides = {}) {
  try {
    (void)parse(text, overrides);
    return "";
  } catch (const RequestError& error) {
    return error.what();
  }
}

const std::string head = "experiment = \"x\"\n";

TEST(config, a_whole_one_is_read) {
  const Config c = parse(R"(experiment = "M11-T3"
title = "fps"
[scene]
name = "studio"
modes = ["low", "hard"]
[sweep]
scheduler = ["thread_static", "thread_dynamic"]
threads = "1..3"
chunk = [1, "2/thread"]
[measure]
launches = 9
budget = "2 min"
interval = 0.05
seconds = 0.1
seed = 7
)");
  EXPECT_EQ(c.experiment, "M11-T3");
  EXPECT_EQ(c.scene, "studio");
  EXPECT_EQ(c.modes, (std::vector<std::string>{"low", "hard"}));
  ASSERT_EQ(c.axes.size(), 3u);
  EXPECT_EQ(c.measure.launches, 9);
  EXPECT_EQ(c.measure.budget_seconds, 120);
  EXPECT_EQ(c.measure.interval, 0.05);
  EXPECT_EQ(c.measure.seconds, 0.1);
  EXPECT_EQ(c.measure.seed, 7u);
}

TEST(config, defaults_are_good) {
  const Config c = parse(head);
  EXPECT_EQ(c.measure.max_launches, 28);
  EXPECT_EQ(parse(head + "[measure]\nlaunches = 5\n").measure.max_launches, 5)
      << "there is no interval to converge";
  EXPECT_EQ(c.measure.launches, 7);
  EXPECT_EQ(c.measure.interval, 0.02);
  EXPECT_EQ(c.scene, "chair-ball");
  EXPECT_TRUE(c.axes.empty());
}

TEST(config, each_bad_value_is_told_by_file_line_and_possible_values) {
  EXPECT_EQ(errors(head + "speed = 3\n"),
            "sweep.toml:2: unknown key \"speed\"; possible: experiment, title, kind, scene, sweep, measure, "
            "claim, published, quick");
  EXPECT_EQ(errors(head + "[scene]\nnmae = \"x\"\n"),
            "sweep.toml:3: unknown key \"scene.nmae\"; possible: name, file, modes");
  EXPECT_EQ(errors(head + "[measure]\nlaunches = 9\nmax_launches = 8\n"),
            "sweep.toml:4: max_launches must be a whole number from 9 to 10000");
  EXPECT_EQ(errors(head + "[measure]\ntimeout = 3\n"),
            "sweep.toml:3: timeout must be a duration such as \"90 s\", \"10 min\" or \"2 h\"");
  EXPECT_EQ(errors(head + "[measure]\nlaunches = 0\n"),
            "sweep.toml:3: launches must be a whole number from 1 to 10000");
  EXPECT_EQ(errors(head + "[measure]\nbudget = \"soon\"\n"),
            "sweep.toml:3: budget must be a duration such as \"90 s\", \"10 min\" or \"2 h\"");
  EXPECT_EQ(errors(head + "[measure]\ninterval = 2\n"),
            "sweep.toml:3: interval must be a number from 0.0001 to 1");
  EXPECT_EQ(errors(head + "kind = \"kernels\"\n"),
            "sweep.toml:2: unknown kind \"kernels\"; built here: picture, accuracy, kernel, pixels");
  EXPECT_EQ(errors(head + "[sweep]\nthreads = 0\n"),
            "sweep.toml:3: threads = 0 is out of range: a whole number from 1 to 1024 is possible");
  EXPECT_EQ(errors(head + "[sweep]\nthreads = [1, -1, 1000000000]\n"),
            "sweep.toml:3: threads = -1 is out of range: a whole number from 1 to 1024 is possible\n"
            "sweep.toml:3: threads = 1000000000 is out of range: a whole number from 1 to 1024 is possible");
  EXPECT_EQ(errors(head + "[sweep]\nthreads = 1.5\n"),
            "sweep.toml:3: threads = 1.5 is not a whole number in range: a whole number from 1 to 1024 is "
            "possible");
  EXPECT_EQ(errors(head + "[sweep]\nthreads = true\n"),
            "sweep.toml:3: threads must be numbers or ranges such as \"1..4\", \"cores\", \"1..2*pus\"");
  EXPECT_EQ(errors(head + "[sweep]\npixel_tolerance = [0.01, 2]\n"),
            "sweep.toml:3: pixel_tolerance = 2 is not possible: a number from 0 to 1, of the film's units, "
            "where 1 is "
            "white; 0 ends no path early");
  EXPECT_EQ(errors(head + "[sweep]\nitem = []\n"),
            "sweep.toml:3: item is an empty list; name one value at least");
  EXPECT_EQ(errors(head + "[scene]\nmodes = [\"easy\"]\n"),
            "sweep.toml:3: unknown mode \"easy\"; possible: low, middle, hard, very_hard");
  EXPECT_TRUE(errors(head + "[sweep]\nscheduler = [\"tbbb\"]\n")
                  .starts_with("sweep.toml:3: unknown scheduler \"tbbb\"; built here: serial, "));
  EXPECT_TRUE(errors(head + "[sweep]\nthread = 3\n")
                  .starts_with("sweep.toml:3: unknown key \"sweep.thread\"; possible: width, height"));
  EXPECT_TRUE(errors(head + "[scene]\nname = \"chair\"\n").starts_with("sweep.toml:2: no scene \"chair\""));
  EXPECT_TRUE(errors("title = \"x\"\n").starts_with("sweep.toml:1: experiment must be a name"));
  EXPECT_TRUE(errors(head + "[sweep\n").starts_with("sweep.toml:2: not TOML: "));
  EXPECT_EQ(errors(head + "sweep = 3\n"), "sweep.toml:2: \"sweep\" must be a table: [sweep]");
}

TEST(config, all_errors_are_told_at_once) {
  const std::string all =
      errors("speed = 1\n[sweep]\nthreads = 0\npin = \"core\"\n[measure]\nlaunches = -1\n");
  EXPECT_EQ(std::ranges::count(all, '\n'), 4) << all;
}

TEST(config, zipped_lists_advance_together) {
  const Config c = parse(head + "[sweep.zip]\nwidth = [128, 256]\nheight = [128, 256]\n");
  ASSERT_EQ(c.axes.size(), 1u);
  EXPECT_EQ(c.axes[0].points.size(), 2u);
  EXPECT_EQ(errors(head + "[sweep.zip]\nheight = [1]\nwidth = [1, 2]\n"),
            "sweep.toml:4: lists in [sweep.zip] advance together: \"width\" has 2 values, \"height\" has 1");
}

TEST(config, a_factor_is_swept_once) {
  EXPECT_EQ(errors(head + "[sweep]\nwidth = 64\n[sweep.zip]\nwidth = [1, 2]\n"),
            "sweep.toml:5: \"width\" stands in [sweep] and in [sweep.zip]; keep one of them");
}

TEST(config, all_instruction_sets_are_those_that_run_here) {
  const Config c = parse(head + "[sweep]\ncore = \"wide\"\nisa = [\"all\"]\n");
  ASSERT_EQ(c.axes.size(), 2u);
  std::vector<std::string> swept;
  for (const std::vector<std::string>& point : c.axes[1].points) swept.push_back(point[0]);
  std::vector<std::string> here;
  for (const Isa& isa : built_isas()) {
    if (runs_here(isa.name)) here.emplace_back(isa.name);
  }
  EXPECT_EQ(swept, here);
  const std::string refused = errors(head + "[sweep]\nisa = \"mmx\"\n");
  EXPECT_EQ(refused.find("sweep.toml:3: isa \"mmx\" cannot be used here; possible: best, "), 0u) << refused;
  EXPECT_TRUE(refused.find(", all") != std::string::npos) << refused;
}

TEST(config, set_changes_one_value_and_is_named_in_errors) {
  const std::string text = head + "[sweep]\nthreads = [1, 2]\n[measure]\nlaunches = 3\nseed = 4\n";
  const Config c = parse(text, {"measure.launches=5", "threads=7", "title=some words"});
  EXPECT_EQ(c.measure.launches, 5);
  EXPECT_EQ(c.measure.seed, 4u) << "its neighbours stay";
  EXPECT_EQ(c.title, "some words");
  ASSERT_EQ(c.axes.size(), 1u);
  EXPECT_EQ(c.axes[0].points, (std::vector<std::vector<std::string>>{{"7"}}));
  EXPECT_EQ(errors(text, {"threads=0"}),
            "--set threads=0:1: threads = 0 is out of range: a whole number from 1 to 1024 is possible");
  EXPECT_TRUE(errors(text, {"threads"}).starts_with("--set threads: must be KEY=VALUE"));
  EXPECT_EQ(parse(c.text).measure.launches, 5) << "the text as run holds what was set";
}

TEST(ranges, refer_to_the_machine) {
  EXPECT_EQ(expand_range("3", machine), (std::vector<int>{3}));
  EXPECT_EQ(expand_range("1..3", machine), (std::vector<int>{1, 2, 3}));
  EXPECT_EQ(expand_range("cores", machine), (std::vector<int>{6}));
  EXPECT_EQ(expand_range("11..pus", machine), (std::vector<int>{11, 12}));
  EXPECT_EQ(expand_range("1..2*pus", machine).size(), 24u);
  for (const char* bad :
       {"", "x", "1..", "..3", "3..1", "1...3", "2*", "1..1000000000", "2147483647", "4096*4096*4096"})
    EXPECT_TRUE(expand_range(bad, machine).empty()) << bad;
}

TEST(ranges, that_refer_to_a_very_large_machine_stop_at_the_largest_thread_count) {
  constexpr MachineSize large{768, 1536};
  EXPECT_EQ(expand_range("cores", large), (std::vector<int>{768}));
  EXPECT_EQ(expand_range("pus", large), (std::vector<int>{1024}));
  EXPECT_EQ(expand_range("2*cores", large), (std::vector<int>{1024}));
}

TEST(durations, have_a_unit) {
  EXPECT_EQ(parse_duration("90 s"), 90);
  EXPECT_EQ(parse_duration("1.5 min"), 90);
  EXPECT_EQ(parse_duration("2 h"), 7200);
  for (const char* bad : {"", "10", "10 minutes", "-1 s", "0 s", "1 s 2", "inf s"})
    EXPECT_EQ(parse_duration(bad), 0) << bad;
}

}  // namespace
}  // namespace raysweep
