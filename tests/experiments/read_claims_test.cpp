// Claims, published tables and quick runs as configs state them.
#include "experiments/read_claims.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "experiments/accuracy_config.h"
#include "experiments/config.h"
#include "experiments/config_toml.h"
#include "experiments/errors.h"
#include "experiments/kernel_plan.h"
#include "experiments/pixels_config.h"
#include "experiments/plan.h"

namespace raysweep {
namespace {

const std::string head =
    "# Does it?\nexperiment = \"x\"\n[scene]\nmodes = [\"low\", \"hard\"]\n[sweep]\nscheduler = "
    "[\"thread_static\"]\nthreads = \"1..4\"\n";
const std::string claim = "[[claim]]\nid = \"a\"\ntext = \"b\"\n";
constexpr MachineSize machine{4, 8};

Config parse(const std::string& text, const std::vector<std::string>& overrides = {}) {
  return parse_config(text, "a.toml", overrides, machine);
}

std::string errors(const std::string& text, const std::vector<std::string>& overrides = {}) {
  try {
    (void)parse(head + text, overrides);
  } catch (const RequestError& error) {
    return error.what();
  }
  return "";
}

TEST(claims_of_configs, are_read_with_all_that_they_say) {
  const Config config =
      parse(head +
            "[[claim]]\nid = \"peak\"\ntext = \"fps peaks\"\nsource = \"M\"\nrule = \"argmax\"\nkey = "
            "\"threads\"\nexpect = \"2*pus\"\nwithin = 0.02\nwhere = { mode = [\"low\", \"hard\"] "
            "}\nfor_each = [\"mode\"]\nrelative_to = { threads = 1 }\nholds = 0.75\napplies_when = "
            "\"cores >= 6 and smt\"\napplies_to = \"ours\"\nwhy = \"w\"\n");
  ASSERT_EQ(config.claims.sheet.claims.size(), 1u);
  const Claim& c = config.claims.sheet.claims[0];
  EXPECT_EQ(config.claims.sheet.question, "Does it?");
  EXPECT_EQ(c.id + c.text + c.source + c.why, "peakfps peaksMw");
  EXPECT_EQ(c.rule, Rule::argmax);
  EXPECT_EQ(c.quantity, "fps");
  EXPECT_EQ(c.key, "threads");
  EXPECT_EQ(c.expected_values, std::vector<std::string>{"2*pus"});
  EXPECT_EQ(c.within, 0.02);
  EXPECT_EQ(c.where, (Selector{{"mode", {"low", "hard"}}}));
  EXPECT_EQ(c.for_each, std::vector<std::string>{"mode"});
  EXPECT_EQ(c.relative_to, (Factors{{"threads", "1"}}));
  EXPECT_EQ(c.holds, "0.75");
  EXPECT_EQ(c.applies_when, "cores >= 6 and smt");
  EXPECT_EQ(c.applies_to, AppliesTo::ours);
}

Claim only_claim(const std::string& text) { return parse(head + claim + text).claims.sheet.claims.at(0); }

TEST(claims_of_configs, have_what_their_rule_needs) {
  const Claim ratio = only_claim(
      "rule = \"ratio\"\nof = { threads = 2 }\nto = { threads = \"cores\" }\nexpect = [\"0.9*cores\", 4]\n");
  EXPECT_EQ(ratio.of, (Factors{{"threads", "2"}}));
  EXPECT_EQ(ratio.to, (Factors{{"threads", "cores"}}));
  EXPECT_EQ(ratio.expect.at(""), (ExpectedRange{"0.9*cores", "4"}));
  const Claim step = only_claim("rule = \"step\"\nkey = \"threads\"\nat = 3\nfrom = 1\nexpect = \"< 1\"\n");
  EXPECT_EQ(step.at + step.from, "31");
  EXPECT_EQ(step.expect.at(""), (ExpectedRange{"", "1", false, true}));
  const Claim line = only_claim(
      "rule = \"linear\"\nkey = \"threads\"\nover = [1, \"pus\"]\nof = \"inverse\"\nintercept = true\n");
  EXPECT_TRUE(line.inverse && line.intercept && line.expect.empty());
  EXPECT_EQ(line.over, (std::vector<std::string>{"1", "pus"}));
  const Claim flat = only_claim(
      "rule = \"plateau\"\nkey = \"threads\"\nvalues = [1, 2]\nexpect = { low = \">= 2\", hard = [1, 2] }\n");
  EXPECT_EQ(flat.values, (std::vector<std::string>{"1", "2"}));
  EXPECT_EQ(flat.expect.at("low"), (ExpectedRange{"2", ""}));
  EXPECT_EQ(flat.expect.at("hard"), (ExpectedRange{"1", "2"}));
  const Claim order = only_claim(
      "rule = \"order\"\nkey = \"mode\"\nexpect = [\"low\", \"hard\"]\nsmallest_first = true\nquantity = "
      "\"frame_seconds\"\n");
  EXPECT_TRUE(only_claim("rule = \"value\"\nexpect = \"> 3\"\n").key.empty());
  EXPECT_TRUE(order.smallest_first);
  EXPECT_EQ(order.quantity, "frame_seconds");
}

TEST(claims_of_configs, that_are_wrong_are_told_by_line) {
  const auto line = [](const std::string& text) { return errors(claim + text); };
  EXPECT_EQ(line("rule = \"sine\"\n"),
            "a.toml:11: unknown rule \"sine\"; possible: ratio, argmax, argmin, plateau, step, linear, "
            "order, value");
  EXPECT_EQ(errors("[[claim]]\nrule = \"plateau\"\nkey = \"threads\"\n"),
            "a.toml:8: a claim needs an id, which is its name in tables: id = \"peak-at-pus\"\n"
            "a.toml:8: a claim needs a text, which says in words what is claimed");
  EXPECT_EQ(errors(claim + "rule = \"plateau\"\nkey = \"threads\"\n" + claim +
                   "rule = \"plateau\"\nkey = \"mode\"\n"),
            "a.toml:14: claim \"a\" is there twice; each needs an id of its own");
  EXPECT_EQ(line("rule = \"plateau\"\nkey = \"threads\"\nat = 3\n"),
            "a.toml:13: unknown key \"claim.at\"; possible: id, text, source, rule, quantity, where, "
            "for_each, expect, "
            "relative_to, holds, applies_when, applies_to, why, key, over, values");
  EXPECT_EQ(line("rule = \"ratio\"\nexpect = \"> 1\"\n"),
            "a.toml:8: rule \"ratio\" needs of = { FACTOR = VALUE }\n"
            "a.toml:8: rule \"ratio\" needs to = { FACTOR = VALUE }");
  EXPECT_EQ(line("rule = \"plateau\"\n"),
            "a.toml:8: rule \"plateau\" needs a key: the factor whose values it compares");
  EXPECT_EQ(line("rule = \"step\"\nkey = \"threads\"\n"),
            "a.toml:8: rule \"step\" needs at: the value of its key at which the step is\n"
            "a.toml:8: rule \"step\" needs expect: a range such as [1.2, 1.3] or \">= 1.5\"");
  EXPECT_EQ(
      line("rule = \"value\"\nexpect = \"> 1\"\nkey = \"mode\"\n"),
      "a.toml:13: unknown key \"claim.key\"; possible: id, text, source, rule, quantity, where, for_each, "
      "expect, relative_to, holds, applies_when, applies_to, why");
  EXPECT_EQ(line("rule = \"value\"\n"),
            "a.toml:8: rule \"value\" needs expect: a range such as [1.2, 1.3] or \">= 1.5\"");
  EXPECT_EQ(line("rule = \"argmax\"\nkey = \"threads\"\n"),
            "a.toml:8: rule \"argmax\" needs expect: values of its key");
  EXPECT_EQ(line("rule = \"order\"\nkey = \"mode\"\nexpect = \"low\"\n"),
            "a.toml:13: rule \"order\" needs two values of its key at least");
  EXPECT_EQ(line("rule = \"plateau\"\nkey = \"threads\"\nexpect = 5\n"),
            "a.toml:13: claim.expect must be a range: [low, high], \"<= X\", \">= X\", \"< X\" or \"> X\"");
  EXPECT_EQ(
      line("rule = \"plateau\"\nkey = \"threads\"\nover = [1]\n"),
      "a.toml:13: claim.over must be a range of numbers: [low, high]; values = [...] names single ones");
  EXPECT_EQ(
      line("rule = \"plateau\"\nkey = \"threads\"\nholds = 2\n"),
      "a.toml:13: claim.holds must be \"all\", \"any\", \"most\" or a share of the groups above 0, up to 1");
  EXPECT_EQ(
      line("rule = \"plateau\"\nkey = \"threads\"\nquantity = \"speed\"\n"),
      "a.toml:13: unknown quantity \"speed\"; possible: fps, frame_seconds, speedup, speedup_one, quality, "
      "imbalance, chunks, empty_region_seconds, build_seconds, rays");
  EXPECT_EQ(line("rule = \"plateau\"\nkey = \"threads\"\napplies_to = \"them\"\n"),
            "a.toml:13: unknown applies_to \"them\"; possible: both, published, ours, neither");
  EXPECT_EQ(line("rule = \"linear\"\nkey = \"threads\"\nof = \"log\"\n"),
            "a.toml:13: unknown of \"log\" of rule \"linear\"; possible: value, inverse");
  EXPECT_EQ(line("rule = \"linear\"\nkey = \"threads\"\nintercept = 1\n"),
            "a.toml:13: intercept must be true or false");
  EXPECT_EQ(line("rule = \"plateau\"\nkey = \"threads\"\nwhere = \"low\"\n"),
            "a.toml:13: claim.where must be a table of factors, such as { threads = 12 }");
  try {
    (void)parse("claim = 3\n" + head);
    FAIL();
  } catch (const RequestError& error) {
    EXPECT_STREQ(error.what(), "a.toml:1: claims are tables of a list, each under a line [[claim]]");
  }
}

TEST(claims_of_configs, have_no_formulas_but_of_the_machine) {
  const std::string told =
      errors(claim + "rule = \"plateau\"\nkey = \"threads\"\napplies_when = \"cpus > 6\"\n");
  EXPECT_EQ(told.substr(0, 80),
            "a.toml:13: claim.applies_when: \"cpus > 6\" is no formula of cores, pus and smt: U");
  EXPECT_NE(errors(claim + "rule = \"plateau\"\nkey = \"threads\"\nexpect = \"<= few\"\n")
                .find("a.toml:13: claim.expect: \"few\" is no formula"),
            std::string::npos);
}

TEST(claims_of_configs, name_only_what_the_sweep_has) {
  EXPECT_EQ(errors(claim + "rule = \"plateau\"\nkey = \"thread\"\n").substr(0, 66),
            "a.toml:12: unknown factor \"thread\" in claim.key; possible: accel, ");
  EXPECT_EQ(errors(claim + "rule = \"plateau\"\nkey = \"threads\"\nwhere = { mode = \"middle\" }\n"),
            "a.toml:13: mode \"middle\" is neither swept nor printed; there are: low, hard");
  EXPECT_EQ(errors(claim + "rule = \"plateau\"\nkey = \"threads\"\nwhere = { mode = \"low\" }\n",
                   {"threads=[1,2]"}),
            "");
  EXPECT_EQ(errors(claim + "rule = \"plateau\"\nkey = \"threads\"\nwhere = { mode = \"hard\" }\n",
                   {"scene.modes=low"}),
            "")
      << "what --set leaves out cannot be judged, which is no error";
  EXPECT_EQ(errors(claim + "rule = \"plateau\"\nkey = \"threads\"\nwhere = { threads = 24 }\n"), "")
      << "which thread counts there are depends on the machine";
  EXPECT_EQ(errors(claim + "rule = \"plateau\"\nkey = \"threads\"\nwhere = { scheduler = \"serial\" }\n"), "")
      << "the base of every run";
}

TEST(published_of_configs, is_found_in_the_sources_and_read_whole) {
  const Config config =
      parse(head +
            "[published]\nfile = \"published/morozov2011_table3_openmp_fps.csv\"\nrows = "
            "\"threads\"\ncolumns = \"mode\"\nfactors = { scheduler = \"omp_static\" }\nnormalise = "
            "\"first_row\"\nmachine = { cores = 6, pus = 12 }\n" +
            claim + "rule = \"plateau\"\nkey = \"threads\"\nwhere = { mode = \"very_hard\" }\n");
  const auto& table = config.claims.sheet.published;
  ASSERT_TRUE(table);
  EXPECT_EQ(table->numbers.size(), 96u);
  EXPECT_EQ(table->numbers[0].factors,
            (Factors{{"mode", "low"}, {"scheduler", "omp_static"}, {"threads", "1"}}));
  EXPECT_EQ(table->numbers[0].text, "6.888");
  EXPECT_EQ(table->quantity, "fps");
  EXPECT_EQ(table->machine.cores, 6);
  const nlohmann::json plan = to_json(make_plan(config, machine));
  EXPECT_EQ(plan.at("published").at("rows").size(), 96u);
  EXPECT_EQ(plan.at("claims").size(), 1u);
  EXPECT_EQ(plan.at("question"), "Does it?");
}

TEST(published_of_configs, may_be_two_tables_of_one_form) {
  const std::string both =
      head +
      "[published]\nfile = \"published/morozov2011_table4_tbb_fps.csv\"\nrows = \"threads\"\ncolumns = "
      "\"mode\"\nfactors = { scheduler = \"tbb_auto\" }\nbeside = { file = "
      "\"published/morozov2011_table3_openmp_fps.csv\", factors = { scheduler = \"omp_static\" } }\n";
  const auto table = parse(both).claims.sheet.published;
  ASSERT_TRUE(table);
  ASSERT_EQ(table->numbers.size(), 192u);
  EXPECT_EQ(table->numbers[0].factors.at("scheduler"), "tbb_auto");
  EXPECT_EQ(table->numbers[96].factors,
            (Factors{{"mode", "low"}, {"scheduler", "omp_static"}, {"threads", "1"}}));
  EXPECT_EQ(table->file,
            "published/morozov2011_table4_tbb_fps.csv and published/morozov2011_table3_openmp_fps.csv");
}

TEST(published_of_configs, that_is_wrong_is_told) {
  EXPECT_EQ(errors("[published]\nfile = \"no.csv\"\nrows = \"threads\"\n"),
            "a.toml:8: no.csv: cannot be opened");
  EXPECT_EQ(
      errors("[published]\nquantity = \"speed\"\n"),
      "a.toml:9: unknown quantity \"speed\"; possible: fps, frame_seconds, speedup, speedup_one, quality, "
      "imbalance, chunks, empty_region_seconds, build_seconds, rays\n"
      "a.toml:8: [published] needs file and rows: file = \"published/NAME.csv\", rows = \"threads\"");
  const std::string right =
      "[published]\nfile = \"published/morozov2011_table3_openmp_fps.csv\"\nrows = \"threads\"\n";
  EXPECT_EQ(errors(right + "columns = \"mode\"\nnormalise = \"rows\"\n"),
            "a.toml:12: unknown normalise \"rows\"; possible: first_row, none");
  EXPECT_NE(
      errors(right).find(".csv:1: not such a table: column \"low\" has no name: give `columns` or `rename`"),
      std::string::npos);
  EXPECT_EQ(errors(right + "columns = \"mode\"\nrow_values = \"thread\"\n"),
            "a.toml:12: published.row_values must hold {}, which stands for what is printed");
  EXPECT_EQ(errors(right + "columns = \"mode\"\nmachine = 6\n"),
            "a.toml:12: published.machine must be a table: { cores = 6, pus = 12 }");
  const std::string beside =
      "a.toml:12: published.beside must be a table: { file = \"published/NAME.csv\", factors = { … } }";
  EXPECT_EQ(errors(right + "columns = \"mode\"\nbeside = \"a.csv\"\n"), beside);
  EXPECT_EQ(errors(right + "columns = \"mode\"\nbeside = { file = \"a.csv\" }\n"), beside);
  EXPECT_EQ(
      errors(right + "columns = \"mode\"\nbeside = { file = \"no.csv\", factors = { pin = \"none\" } }\n"),
      "a.toml:12: no.csv: cannot be opened");
}

TEST(quick_of_configs, lists_what_set_would_change) {
  const std::string text = head + "[quick]\nset = [\"threads=[1,2]\", \"measure.launches=6\"]\n";
  EXPECT_EQ(parse(text).claims.quick, (std::vector<std::string>{"threads=[1,2]", "measure.launches=6"}));
  EXPECT_EQ(quick_overrides(read_toml(text, "a.toml", {})), parse(text).claims.quick);
  EXPECT_TRUE(quick_overrides(read_toml(head, "a.toml", {})).empty());
  EXPECT_EQ(errors("[quick]\n"),
            "a.toml:8: [quick] needs set: what a quick run changes, such as [\"threads=[1,2]\"]");
  EXPECT_EQ(errors("[quick]\nset = [\"threads\"]\n"),
            "a.toml:9: \"threads\" in quick.set must be KEY=VALUE, as --set has it");
}

TEST(claims_of_configs, stand_beside_the_command_that_makes_the_run) {
  EXPECT_EQ(parse(head).claims.sheet.command, "raysweep run a.toml");
  EXPECT_EQ(parse(head, {"threads=2", "measure.budget='1 min'"}).claims.sheet.command,
            R"(raysweep run a.toml --set threads=2 --set 'measure.budget='\''1 min'\''')");
  const Config of_sources =
      parse_config(head, RAYSWEEP_SOURCE_DIR "/experiments/configs/x.toml", {}, machine);
  EXPECT_EQ(of_sources.claims.sheet.command, "raysweep run experiments/configs/x.toml");
}

TEST(claims_of_configs, are_in_the_plans_of_all_kinds) {
  const std::string end =
      "[[claim]]\nid = \"a\"\ntext = \"b\"\nrule = \"argmin\"\nkey = \"method\"\nexpect = \"wald\"\n";
  const auto head_of = [](const std::string& kind) {
    return "# Why?\nexperiment = \"x\"\nkind = \"" + kind + "\"\n";
  };
  const auto kernel = parse_kernel_config(head_of("kernel") + end, "a.toml", {}, 2);
  const auto accuracy = parse_accuracy_config(head_of("accuracy") + end, "a.toml", {});
  const auto pixels = parse_pixels_config(
      head_of("pixels") + end.substr(0, end.rfind("wald")) + "moller_trumbore\"\n", "a.toml", {});
  for (const nlohmann::json& plan :
       {to_json(make_plan(kernel)), to_json(make_plan(accuracy)), to_json(pixels)}) {
    EXPECT_EQ(plan.at("question"), "Why?");
    EXPECT_EQ(plan.at("claims").at(0).at("id"), "a");
  }
  EXPECT_EQ(kernel.claims.sheet.claims[0].quantity, "nanoseconds");
  EXPECT_EQ(accuracy.claims.sheet.claims[0].quantity, "t_error_p99");
  EXPECT_EQ(pixels.claims.sheet.claims[0].quantity, "wrong_pixels");
}

}  // namespace
}  // namespace raysweep
