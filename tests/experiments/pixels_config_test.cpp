// Pixels experiments as their files state them.
#include "experiments/pixels_config.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "experiments/errors.h"

namespace raysweep {
namespace {

const std::string head = "experiment = \"x\"\nkind = \"pixels\"\n";

PixelsConfig parse(const std::string& text, const std::vector<std::string>& overrides = {}) {
  return parse_pixels_config(text, "a.toml", overrides);
}

std::string errors(const std::string& text) {
  try {
    (void)parse(text);
  } catch (const RequestError& error) {
    return error.what();
  }
  return "";
}

TEST(pixels_config, asks_for_one_picture_by_all_that_there_is_unless_told_otherwise) {
  const PixelsConfig config = parse(head);
  ASSERT_EQ(config.groups.size(), 1u);
  EXPECT_EQ(config.groups[0].scene, "studio");
  EXPECT_EQ(config.groups[0].offset, 0);
  // Scalar and m11 have both precisions, wide has floats.
  EXPECT_EQ(config.cell_count(), methods().size() * 5);
  EXPECT_EQ(config.left_out, (std::vector<std::string>{"core wide in double: it has floats alone"}));
  EXPECT_TRUE(is_pixels(head, "a.toml", {}));
  EXPECT_FALSE(is_pixels("kind = \"accuracy\"", "a.toml", {}));
}

TEST(pixels_config, every_cell_has_a_key_of_its_own_by_scene_offset_and_mode) {
  const nlohmann::json plan = to_json(
      parse(head + "[sweep]\nscene = [\"ice\", \"studio\", \"ice\"]\noffset = [0, 1e5]\ncore = \"scalar\"\n"
                   "mode = \"hard\"\nmethod = \"morozov\"\nprecision = \"float\"\n[measure]\nrounds = 3\n"));
  EXPECT_EQ(plan["cells"],
            (nlohmann::json{"ice/hard/scalar/morozov/float", "ice+100000/hard/scalar/morozov/float",
                            "studio/hard/scalar/morozov/float", "studio+100000/hard/scalar/morozov/float"}));
  EXPECT_EQ(plan["kind"], "pixels");
  EXPECT_EQ(plan["rounds"], 3);
}

TEST(pixels_config, samples_are_swept_against_a_reference_of_many) {
  const PixelsConfig config =
      parse(head +
            "[sweep]\ncore = \"wide\"\nmethod = \"morozov\"\nprecision = \"float\"\npattern = [\"circle\", "
            "\"grid\", \"circle\"]\nsubpixels = [4, 9]\n");
  EXPECT_EQ(
      to_json(config)["cells"],
      (nlohmann::json{"studio/low/wide/morozov/float/circle/4", "studio/low/wide/morozov/float/circle/9",
                      "studio/low/wide/morozov/float/grid/4", "studio/low/wide/morozov/float/grid/9"}));
  EXPECT_EQ(config.settings.reference_subpixels, 1024);
  EXPECT_EQ(parse(head).settings.reference_subpixels, 0) << "rounding alone is judged at the mode's samples";
  EXPECT_EQ(parse(head + "[measure]\nreference_subpixels = 64\n").settings.reference_subpixels, 64);
}

TEST(pixels_config, bad_samplings_are_told_by_line) {
  EXPECT_EQ(errors(head + "[sweep]\npattern = []\nsubpixels = [0, 2.5]\n"),
            "a.toml:4: pattern is an empty list; name one value at least\n"
            "a.toml:5: subpixels must be numbers from 1 to 65536\n"
            "a.toml:5: subpixels must be whole numbers");
  const std::string problem = errors(head + "[sweep]\npattern = \"round\"\n");
  EXPECT_TRUE(problem.starts_with("a.toml:4: unknown pattern \"round\"")) << problem;
}

TEST(pixels_config, overrides_change_it_and_its_text) {
  const PixelsConfig config = parse(head, {"method=morozov", "measure.rounds=5"});
  EXPECT_EQ(config.cell_count(), 5u);
  EXPECT_EQ(config.settings.rounds, 5);
  EXPECT_EQ(parse(config.text).cell_count(), 5u) << config.text;
}

TEST(pixels_config, each_bad_value_is_told_by_file_line_and_possible_values_all_at_once) {
  EXPECT_EQ(errors(head + "[scene]\n"),
            "a.toml:3: unknown key \"scene\"; possible: experiment, title, kind, sweep, measure, claim, "
            "published, quick");
  EXPECT_EQ(
      errors(head + "[sweep]\nmethod = \"wald\"\ncore = \"narrow\"\noffset = [0, \"far\"]\nscene = 3\n"
                    "mode = \"easy\"\nthreads = 2\n[measure]\nrounds = 0\nlaunches = 3\n"),
      "a.toml:9: unknown key \"sweep.threads\"; possible: scene, offset, mode, core, method, precision, "
      "pattern, subpixels\n"
      "a.toml:7: scene must be strings in quotes\n"
      "a.toml:6: offset must be numbers from -1000000000 to 1000000000\n"
      "a.toml:8: unknown mode \"easy\"; built here: low, middle, hard, very_hard, all\n"
      "a.toml:4: unknown method \"wald\"; built here: moller_trumbore, morozov, woop_watertight, all\n"
      "a.toml:5: unknown core \"narrow\"; built here: scalar, wide, m11, all\n"
      "a.toml:12: unknown key \"measure.launches\"; possible: scale, rounds, seconds, seed, "
      "reference_subpixels\n"
      "a.toml:11: rounds must be a whole number from 1 to 10000");
  EXPECT_EQ(errors(head + "[sweep]\noffset = []\n"),
            "a.toml:4: offset is an empty list; name one value at least");
  EXPECT_EQ(errors(head + "[sweep]\ncore = \"wide\"\nprecision = \"double\"\n"),
            "a.toml:3: nothing is left to run: core wide in double: it has floats alone");
  EXPECT_NE(errors(head + "[sweep]\nscene = [\"studio\", \"none.toml\"]\n").find("a.toml:4: "),
            std::string::npos);
}

}  // namespace
}  // namespace raysweep
