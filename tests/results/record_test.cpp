#include "results/record.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/results/make_record.h"

namespace raysweep {
namespace {

class RecordFile : public testing::Test {
 public:
  std::filesystem::path file =
      std::filesystem::temp_directory_path() / ("raysweep_records_" + std::to_string(getpid()));
  ~RecordFile() override { std::filesystem::remove(file); }
  void write(const std::string& text) const { std::ofstream(file) << text; }
};

TEST(record, fps_is_frames_by_total_time) {
  Record r = make_record("serial", 1, 0, 1);
  r.frame_seconds = {{0.5, 0.5, 1.0}};
  EXPECT_DOUBLE_EQ(r.fps(), 1.5) << "not the mean of 2, 2 and 1";
  r.frame_seconds = {{0.5}, {0.25, 0.25}};
  EXPECT_DOUBLE_EQ(r.fps(), 6) << "co-running processes add up";
}

TEST(record, comes_back_from_json_as_it_went) {
  Record r = make_record("omp_dynamic", 3, 2, 0.125);
  r.workers = {{5, 2, 1}, {7, 3, 0}};
  r.chunks_made = {5, 6};
  r.rays = {1, 2, 3, 4};
  r.image_hash = "abc";
  r.state.steal_share = 0.25;  // the others stay unknown
  r.launch_seconds = 0.5;
  EXPECT_EQ(to_json(record_from_json(to_json(r))), to_json(r));
  Record together = make_record("serial", 1, 0, 0.5, 2);
  EXPECT_EQ(to_json(record_from_json(to_json(together))), to_json(together));
  EXPECT_TRUE(to_json(r)["frame_seconds"].front().is_number()) << "one process: a plain list";
}

TEST_F(RecordFile, a_line_that_its_writer_did_not_finish_is_left_out) {
  const std::string line = to_json(make_record("serial", 1, 0, 1)).dump();
  write(line + "\n" + line + "\n" + line.substr(0, line.size() / 2));
  EXPECT_EQ(read_records(file).size(), 2u);
}

TEST_F(RecordFile, another_line_that_is_no_record_is_told_with_its_number) {
  const std::string line = to_json(make_record("serial", 1, 0, 1)).dump();
  write(line + "\n{\"schema\": 1}\n");
  try {
    (void)read_records(file);
    FAIL();
  } catch (const RecordError& error) {
    EXPECT_NE(std::string(error.what()).find(":2: not a record"), std::string::npos) << error.what();
  }
}

TEST_F(RecordFile, a_record_of_schema_1_is_read_as_one_without_early_endings) {
  auto json = to_json(make_record("serial", 1, 0, 1));
  json["schema"] = 1;
  for (const char* since_2 : {"pixel_tolerance", "branches", "left_out"}) json.erase(since_2);
  write(json.dump() + "\n");
  const auto records = read_records(file);
  ASSERT_EQ(records.size(), 1u);
  EXPECT_EQ(records[0].pixel_tolerance, 0);
  EXPECT_EQ(records[0].branches, 1024);
  json["schema"] = 2;
  write(json.dump() + "\n");
  EXPECT_THROW((void)read_records(file), RecordError) << "schema 2 has them";
}

TEST_F(RecordFile, a_record_of_schema_3_is_read_and_knows_nothing_of_the_machines_state) {
  auto json = to_json(make_record("serial", 1, 0, 1));
  json["schema"] = 3;
  json["machine"].erase("quota");
  for (const char* since_4 :
       {"state", "launch_seconds", "warm", "twin", "slowdown", "scene_hash", "config_hash"})
    json.erase(since_4);
  write(json.dump() + "\n");
  const auto records = read_records(file);
  ASSERT_EQ(records.size(), 1u);
  EXPECT_FALSE(records[0].state.steal_share);
  EXPECT_EQ(records[0].twin, 0);
}

TEST_F(RecordFile, another_schema_is_refused_by_a_sentence) {
  auto json = to_json(make_record("serial", 1, 0, 1));
  json["schema"] = 99;
  write(json.dump() + "\n");
  try {
    (void)read_records(file);
    FAIL();
  } catch (const RecordError& error) {
    EXPECT_NE(std::string(error.what()).find("schema 99 is unknown here; this version reads schemas 1 to 4"),
              std::string::npos);
  }
}

}  // namespace
}  // namespace raysweep
