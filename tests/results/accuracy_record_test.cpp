// Records of accuracy experiments, written and read back.
#include "results/accuracy_record.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "results/record.h"
#include "tests/results/accuracy_records.h"

namespace raysweep {
namespace {

TEST(accuracy_record, comes_back_as_it_was_written) {
  AccuracyRecord r = made_up("wald", "W1", 1, "division=late");
  r.seed = 7;
  r.variant.division = "late";
  r.mesh_rays = 11, r.boundary = 12, r.false_hits = 13, r.false_misses = 14, r.nonfinite = 15;
  r.missed_rays = 16, r.extra = 17, r.uncovered = 18, r.other_nearest = 19;
  const std::string line = to_line(r);
  const AccuracyRecord back = accuracy_record_from_json(nlohmann::json::parse(line));
  EXPECT_EQ(to_line(back), line);
  EXPECT_EQ(back.change, "division=late");
  EXPECT_EQ(back.variant, r.variant);
  EXPECT_EQ(back.difficulty, 0.1);
  EXPECT_EQ(back.uncovered, 18u);
  EXPECT_EQ(back.t_error.p999, 3);
  EXPECT_EQ(back.t_error.mean, 0.75);
  EXPECT_EQ(back.weight_error.max, 40);
  EXPECT_EQ(back.other_nearest, 19u);
}

TEST(accuracy_record, without_errors_has_null_quantiles_and_reads_them_as_nan) {
  const nlohmann::json json = to_json(made_up("wald", "W1", 0));
  EXPECT_EQ(json["off_plane"].dump(),
            R"({"count":0,"max":null,"mean":null,"p50":null,"p99":null,"p999":null})");
  const AccuracyRecord back = accuracy_record_from_json(nlohmann::json::parse(json.dump()));
  EXPECT_EQ(back.off_plane.count, 0u);
  EXPECT_TRUE(std::isnan(back.off_plane.p50));
}

TEST(accuracy_record, has_the_fields_of_its_interface) {
  const nlohmann::json json = to_json(made_up("wald", "W1", 0));
  for (const char* name :
       {"schema",     "kind",         "experiment", "cell",          "seed",        "method",
        "variant",    "precision",    "case",       "difficulty",    "trials",      "rays",
        "false_hits", "false_misses", "boundary",   "missed_rays",   "extra",       "uncovered",
        "launch",     "round",        "valid",      "reason",        "nonfinite",   "t_error",
        "uv_error",   "consistency",  "off_plane",  "other_nearest", "weight_error"})
    EXPECT_TRUE(json.contains(name)) << name;
  for (const char* factor : {"division", "reciprocal", "order", "edges", "early_out", "output", "data"})
    EXPECT_TRUE(json["variant"].contains(factor)) << factor;
}

TEST(accuracy_record, of_another_kind_or_schema_is_refused_with_its_line) {
  const auto file = std::filesystem::temp_directory_path() / "raysweep_accuracy_records.jsonl";
  const auto refusal = [&](const char* key, const nlohmann::json& value) -> std::string {
    nlohmann::json changed = to_json(made_up("wald", "W1", 0));
    changed[key] = value;
    std::ofstream(file) << to_line(made_up("wald", "W1", 0)) << '\n' << changed.dump() << '\n';
    try {
      (void)read_accuracy_records(file);
    } catch (const RecordError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(refusal("schema", 1),
            file.string() + ":2: not a record: schema 1 is unknown here; this version reads 3");
  EXPECT_EQ(refusal("kind", "picture"),
            file.string() + ":2: not a record: kind \"picture\" where \"accuracy\" was expected");
  std::filesystem::remove(file);
}

}  // namespace
}  // namespace raysweep
