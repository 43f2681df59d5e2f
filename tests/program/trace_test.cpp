// The timeline that `render --trace` writes.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "tests/program/program.h"

namespace raysweep {
namespace {

struct Span {
  double begin, end;
  size_t first_item, items;
};

class Trace : public testing::Test {
 public:
  TemporaryFolder folder;
  std::map<std::string, int> rows;         // by name
  std::map<int, std::vector<Span>> spans;  // by row

  void record(std::vector<std::string> more) {
    const std::string file = folder.file("trace.json");
    std::vector<std::string> arguments{
        "render", "--scene",  "studio", "--width", "64",    "--height",           "40",      "--item",
        "rows",   "--frames", "3",      "--json",  "--out", folder.file("p.png"), "--trace", file};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const ProgramResult result = run_program(arguments);
    ASSERT_EQ(result.exit_code, 0) << result.err;
    ASSERT_TRUE(nlohmann::json::parse(result.out).contains("workers"));
    const auto trace = nlohmann::json::parse(read_file(file));
    for (const auto& event : trace.at("traceEvents")) {
      const int row = event.at("tid").get<int>();
      if (event.at("ph") == "M") {
        if (event.at("name") == "thread_name") rows[event.at("args").at("name").get<std::string>()] = row;
        continue;
      }
      ASSERT_EQ(event.at("ph"), "X");
      const double begin = event.at("ts").get<double>(), end = begin + event.at("dur").get<double>();
      spans[row].push_back({begin, end, event.at("args").value("first_item", size_t{0}),
                            event.at("args").value("items", size_t{0})});
    }
  }
};

constexpr double rounding = 0.002;  // µs: the file has three digits

TEST_F(Trace, has_every_item_of_every_frame_once_inside_its_frame) {
  record({"--scheduler", "thread_dynamic", "--threads", "3", "--chunk", "7"});
  ASSERT_EQ(rows.size(), 4u) << "frames and three workers";
  const std::vector<Span>& frames = spans[rows.at("frames")];
  ASSERT_EQ(frames.size(), 3u);
  for (const Span& frame : frames) {
    std::vector<int> runs(40);
    for (int worker = 0; worker < 3; ++worker) {
      for (const Span& chunk : spans[rows.at("worker " + std::to_string(worker))]) {
        if (chunk.begin < frame.begin - rounding || chunk.end > frame.end + rounding) continue;
        for (size_t i = 0; i < chunk.items; ++i) runs.at(chunk.first_item + i)++;
      }
    }
    EXPECT_EQ(std::ranges::count(runs, 1), 40);
  }
}

TEST_F(Trace, chunks_of_a_worker_follow_each_other) {
  record({"--scheduler", "thread_stealing", "--threads", "2"});
  for (int worker = 0; worker < 2; ++worker) {
    const std::vector<Span>& chunks = spans[rows.at("worker " + std::to_string(worker))];
    for (size_t i = 1; i < chunks.size(); ++i) EXPECT_LE(chunks[i - 1].end, chunks[i].begin + rounding);
  }
}

TEST(trace, a_file_that_cannot_be_is_refused_before_the_work) {
  const TemporaryFolder folder;
  for (const char* trace : {"/nowhere/t.json", "trace.txt"}) {
    const ProgramResult result = run_program({"render", "--out", folder.file("p.png"), "--trace", trace});
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_NE(result.err.find("--trace"), std::string::npos) << result.err;
    EXPECT_EQ(folder.entries(), 0u);
  }
}

}  // namespace
}  // namespace raysweep
