// Accuracy experiments as their files state them.
#include "experiments/accuracy_config.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>

#include "experiments/errors.h"
#include "schedulers/binding.h"

namespace raysweep {
namespace {

const std::string head = "experiment = \"x\"\nkind = \"accuracy\"\n";

AccuracyConfig parse(const std::string& text, const std::vector<std::string>& overrides = {}) {
  return parse_accuracy_config(text, "a.toml", overrides);
}

std::string errors(const std::string& text) {
  try {
    (void)parse(text);
  } catch (const RequestError& error) {
    return error.what();
  }
  return "";
}

TEST(accuracy_config, asks_for_everything_in_base_variants_unless_told_otherwise) {
  const AccuracyConfig config = parse(head);
  EXPECT_EQ(config.methods.size(), study_method_names().size());
  EXPECT_EQ(config.cases.size(), all_cases().size());
  EXPECT_EQ(config.precisions.size(), 2u);
  EXPECT_FALSE(config.variants.is_star);
  EXPECT_EQ(config.settings.ray_count, 10'000u);
  EXPECT_EQ(config.settings.experiment, "x");
  EXPECT_EQ(make_plan(config).threads, allowed_processors().size());
}

TEST(accuracy_config, takes_lists_single_names_and_all_each_once) {
  const AccuracyConfig config =
      parse(head +
            "[sweep]\nmethod = [\"wald\", \"plucker\", \"wald\"]\ncase = \"D1\"\nprecision = \"double\"\n"
            "variant = \"star\"\n[measure]\ntrials = 77\nseed = 9\nthreads = 3\n");
  EXPECT_EQ(config.methods, (std::vector<std::string>{"wald", "plucker"}));
  EXPECT_EQ(config.cases, (std::vector<std::string>{"D1"}));
  EXPECT_EQ(config.precisions, (std::vector<Precision>{Precision::double_precision}));
  EXPECT_TRUE(config.variants.is_star);
  EXPECT_EQ(config.settings.ray_count, 77u);
  EXPECT_EQ(config.settings.seed, 9u);
  EXPECT_EQ(make_plan(config).threads, 3u);
  EXPECT_EQ(parse(head + "[sweep]\ncase = [\"D1\", \"all\"]\n").cases.size(), all_cases().size());
}

TEST(accuracy_config, overrides_change_it_and_its_text) {
  const AccuracyConfig config = parse(head, {"method=wald", "measure.trials=5"});
  EXPECT_EQ(config.methods, (std::vector<std::string>{"wald"}));
  EXPECT_EQ(config.settings.ray_count, 5u);
  EXPECT_EQ(parse(config.text).methods, config.methods) << config.text;
}

TEST(accuracy_config, each_bad_value_is_told_by_file_line_and_possible_values_all_at_once) {
  EXPECT_EQ(errors(head + "[scene]\n"),
            "a.toml:3: unknown key \"scene\"; possible: experiment, title, kind, sweep, measure, claim, "
            "published, quick");
  EXPECT_EQ(errors("kind = \"accuracy\"\n"),
            "a.toml:1: experiment must be a name, such as \"M11-T3\"; it names the folder of the run");
  EXPECT_EQ(errors(head + "[sweep]\nprecision = [\"float\", \"half\"]\nvariant = []\nthreads = 2\n"
                          "method = []\n[measure]\ntrials = 0\nlaunches = 3\n"),
            "a.toml:6: unknown key \"sweep.threads\"; possible: method, precision, case, variant\n"
            "a.toml:7: method is an empty list; name one value at least\n"
            "a.toml:4: unknown precision \"half\"; built here: float, double, all\n"
            "a.toml:5: variant is an empty list; name one value at least\n"
            "a.toml:10: unknown key \"measure.launches\"; possible: trials, seed, threads\n"
            "a.toml:9: trials must be a whole number from 1 to 10000000");
  EXPECT_EQ(
      errors(head + "[sweep]\nmethod = [\"wald\",\n\"wlad\"]\ncase = 3\n"),
      "a.toml:5: unknown method \"wlad\"; built here: moller_trumbore, kensler_shirley, morozov, shevtsov, "
      "badouel, wald, keidy, perpendicular_planes, plucker, half_spaces, signed_areas, angle_sum, "
      "woop_watertight, baldwin_weber, havel_herout, all\n"
      "a.toml:6: case must be strings in quotes");
}

TEST(accuracy_plan, has_every_cell_once_and_names_what_there_is_not) {
  const AccuracyPlan plan = make_plan(parse(
      head + "[sweep]\nmethod = [\"wald\", \"angle_sum\"]\ncase = [\"S1\", \"D5\"]\nvariant = \"star\"\n"));
  const nlohmann::json json = to_json(plan);
  std::set<std::string> cells;
  for (const auto& key : json["cells"]) cells.insert(key.get<std::string>());
  EXPECT_EQ(cells.size(), plan.cell_count());
  EXPECT_EQ(json["cells"].size(), plan.cell_count());
  const size_t levels = case_of("S1").difficulties.size() + case_of("D5").difficulties.size();
  EXPECT_EQ(plan.batches.size(), 2 * levels);
  EXPECT_EQ(plan.cell_count() + levels * plan.left_out.size(), levels * 2 * 2 * 13)
      << "two methods and precisions, thirteen variants, each run or left out";
  bool names_late_angles = false;
  for (const auto& one : json["left_out"])
    names_late_angles =
        names_late_angles || (one["method"] == "angle_sum" && one["change"] == "division=late" &&
                              one["reason"] == "a sum of angles cannot be scaled: the point must be known");
  EXPECT_TRUE(names_late_angles) << json["left_out"];
}

TEST(accuracy_plan, has_the_listed_variants_alone_and_names_who_lacks_one) {
  const nlohmann::json json = to_json(make_plan(
      parse(head +
            "[sweep]\nmethod = [\"wald\", \"angle_sum\"]\ncase = \"D5\"\nprecision = \"float\"\nvariant = "
            "[\"division=late\"]\n")));
  ASSERT_EQ(json["cells"].size(), case_of("D5").difficulties.size());
  for (const auto& key : json["cells"])
    EXPECT_TRUE(key.get<std::string>().starts_with("wald/division=late/float/D5/")) << key;
  ASSERT_EQ(json["left_out"].size(), 1u);
  EXPECT_EQ(json["left_out"][0]["method"], "angle_sum");
  const std::string unknown = errors(head + "[sweep]\nvariant = \"rays=8\"\n");
  EXPECT_TRUE(unknown.starts_with(
      "a.toml:4: unknown variant \"rays=8\"; possible: base, star, product, division=late, "))
      << unknown << ": packets find no more and no less than single rays";
}

TEST(accuracy_plan, of_base_variants_leaves_nothing_out) {
  EXPECT_TRUE(make_plan(parse(head)).left_out.empty());
}

}  // namespace
}  // namespace raysweep
