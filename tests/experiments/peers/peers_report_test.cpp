// The document and the tables of a comparison.
#include "experiments/peers/peers_report.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace raysweep {
namespace {

PeersResult example() {
  PeersRow row;
  row.scene = "chair-ball";
  row.triangles = 10817;
  row.rays = 4000;
  row.kind = RayKind::mirror;
  row.duel_class = DuelClass::best;
  row.ours = "scalar";
  row.embree = "avx2 high 8 coherent";
  row.ours_per_second = 2e6;
  row.embree_per_second = 8e6;
  row.ratio = {0.25, Estimate::Bounds{0.24, 0.26}, 15};
  row.between = {12, 9};
  PictureRow picture;
  picture.scene = "pebble";
  picture.mode = "hard";
  picture.triangles = 69620;
  picture.width = 1024;
  picture.height = 768;
  picture.threads = 2;
  picture.ours = "avx2";
  picture.embree = "avx2 medium 8 coherent, mirrored single incoherent";
  picture.ours_per_second = 3;
  picture.embree_per_second = 4;
  picture.ratio = {0.75, Estimate::Bounds{0.7, 0.8}, 7};
  picture.embree_share = 0.64;
  picture.differences = {17, 0.5};
  return {{row}, {{"chair-ball", 10817, "high", 2, {0.02, 0}, {0.03, 1 << 20}, {0.7, {}, 7}}}, {picture}, {}};
}

std::set<std::string> keys(const nlohmann::json& object) {
  std::set<std::string> names;
  for (const auto& [key, value] : object.items()) names.insert(key);
  return names;
}

TEST(peers_report, has_the_fields_that_scripts_rely_on) {
  const auto json = to_json(example());
  EXPECT_EQ(keys(json), (std::set<std::string>{"rows", "pictures", "builds"}));
  const auto& row = json["rows"][0];
  EXPECT_EQ(keys(row),
            (std::set<std::string>{"scene", "triangles", "kind", "class", "ours", "ours_mrays", "embree",
                                   "embree_mrays", "ratio", "low", "high", "hits_differ"}));
  EXPECT_EQ(row["kind"], "mirror");
  EXPECT_EQ(row["class"], "best");
  EXPECT_EQ(row["ours_mrays"], 2.0);
  EXPECT_EQ(row["ratio"], 0.25);
  EXPECT_EQ(row["low"], 0.24);
  EXPECT_EQ(row["hits_differ"], 12);
  const auto& build = json["builds"][0];
  EXPECT_EQ(keys(build),
            (std::set<std::string>{"scene", "triangles", "class", "threads", "ours_seconds", "embree_seconds",
                                   "ours_bytes", "embree_bytes", "ratio", "low", "high"}));
  EXPECT_EQ(build["threads"], 2);
  EXPECT_EQ(build["ratio"], 0.7);
  EXPECT_EQ(build["ours_bytes"], nullptr) << "not counted is not 0";
  EXPECT_EQ(build["embree_bytes"], 1 << 20);
}

TEST(peers_report, has_the_fields_of_pictures) {
  const nlohmann::json json = to_json(example());
  const auto& picture = json["pictures"][0];
  EXPECT_EQ(keys(picture),
            (std::set<std::string>{"scene", "triangles", "mode", "width", "height", "threads", "ours",
                                   "ours_fps", "embree", "embree_fps", "ratio", "low", "high", "embree_share",
                                   "pixels_differ", "largest_difference"}));
  EXPECT_EQ(picture["mode"], "hard");
  EXPECT_EQ(picture["ours_fps"], 3.0);
  EXPECT_EQ(picture["high"], 0.8);
  EXPECT_EQ(picture["embree_share"], 0.64);
  EXPECT_EQ(picture["pixels_differ"], 17);
  EXPECT_EQ(picture["largest_difference"], 0.5);
  EXPECT_EQ(to_json(PeersResult())["pictures"], nlohmann::json::array());
}

TEST(peers_report, an_unknown_interval_is_null) {
  PeersResult result = example();
  result.rows[0].ratio.interval.reset();
  result.pictures[0].ratio.interval.reset();
  EXPECT_EQ(to_json(result)["rows"][0]["low"], nullptr);
  EXPECT_EQ(to_json(result)["pictures"][0]["high"], nullptr);
}

TEST(peers_report, says_above_the_pictures_who_makes_them_and_how) {
  PeersRequest request;
  request.pictures.rounds = 9;
  const Table table = pictures_table(example(), request, {embree_layout, "3.13.5", true, nullptr, nullptr});
  for (const char* words : {"Embree 3.13.5", "assertions", "planes and spheres", "32 × 32", "9 rounds"})
    EXPECT_NE(table.caption.find(words), std::string::npos) << table.caption;
  for (const char* words : {"1024 × 768", "0.750 [0.700, 0.800]", "64 %", " 17 "})
    EXPECT_NE(to_text(table).find(words), std::string::npos) << to_text(table);
}

TEST(peers_report, says_above_the_table_what_is_compared_and_how) {
  PeersRequest request;
  request.duel.rounds = 15;
  const Table table = rays_table(example(), request, {embree_layout, "3.13.5", true, nullptr, nullptr});
  for (const char* words : {"Embree 3.13.5", "assertions", "one thread", "1024 × 768", "15 rounds"})
    EXPECT_NE(table.caption.find(words), std::string::npos) << table.caption;
  EXPECT_NE(to_text(table).find("0.250 [0.240, 0.260]"), std::string::npos) << to_text(table);
  EXPECT_NE(to_text(table).find("12 (9)"), std::string::npos);
  for (const Table& t :
       {table, builds_table(example()),
        pictures_table(example(), request, {embree_layout, "3.13.5", true, nullptr, nullptr})})
    for (const auto& row : t.rows) EXPECT_EQ(row.size(), t.columns.size());
}

}  // namespace
}  // namespace raysweep
