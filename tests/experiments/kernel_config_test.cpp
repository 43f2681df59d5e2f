// Kernel experiments as their files state them.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "experiments/errors.h"
#include "experiments/kernel_plan.h"

namespace raysweep {
namespace {

const std::string head = "experiment = \"x\"\nkind = \"kernel\"\n";
constexpr int processors = 6;

KernelConfig parse(const std::string& text, const std::vector<std::string>& overrides = {}) {
  return parse_kernel_config(text, "a.toml", overrides, processors);
}

KernelPlan plan_of(const std::string& sweep) { return make_plan(parse(head + "[sweep]\n" + sweep)); }

std::set<std::string> keys_of(const KernelPlan& plan) {
  std::set<std::string> keys;
  for (const KernelCell& cell : plan.cells) keys.insert(cell.key);
  return keys;
}

std::string errors(const std::string& text) {
  try {
    static_cast<void>(parse(text));
  } catch (const RequestError& error) {
    return error.what();
  }
  return "";
}

TEST(kernel_config, times_all_methods_on_random_tests_unless_told_otherwise) {
  const KernelConfig config = parse(head);
  EXPECT_EQ(config.methods.size(), study_method_names().size());
  EXPECT_EQ(config.protocols, (std::vector<std::string>{"random"}));
  EXPECT_EQ(config.precisions.size(), 2u);
  EXPECT_EQ(config.threads, (std::vector<int>{1}));
  EXPECT_FALSE(config.variants.is_star);
  EXPECT_EQ(config.variants.changes, (std::vector<std::string>{"base"}));
  EXPECT_EQ(config.experiment, "x");
  EXPECT_EQ(config.title, "x");
  EXPECT_EQ(config.measure.rounds, 9);
}

TEST(kernel_config, schedulers_are_those_that_leave_no_thread_spinning) {
  EXPECT_EQ(parse(head).schedulers, (std::vector<std::string>{"shares"}));
  EXPECT_EQ(parse(head + "[sweep]\nscheduler = [\"thread_dynamic\", \"shares\"]\n").schedulers,
            (std::vector<std::string>{"thread_dynamic", "shares"}));
  const std::string refused = errors(head + "[sweep]\nscheduler = \"omp_static\"\n");
  EXPECT_TRUE(
      refused.starts_with("a.toml:4: unknown scheduler \"omp_static\"; built here: shares, thread_static, "))
      << refused;
}

TEST(kernel_config, takes_lists_single_values_and_all_each_once) {
  const KernelConfig config = parse(
      head +
      "[sweep]\nkernel = \"intersection\"\nmethod = [\"wald\", \"plucker\", \"wald\"]\nprotocol = \"all\"\n"
      "hit_rate = [0, 0.25, 1, 1.0]\nprecision = \"double\"\nvariants = \"star\"\n"
      "scene = [\"grotto\", \"chair-ball\"]\nthreads = [1, 2, \"all\", 2]\n"
      "[measure]\nrounds = 3\nsamples = 4\nmin_time = 0.5\nbudget = \"2 min\"\nseed = 9\n");
  EXPECT_EQ(config.methods, (std::vector<std::string>{"wald", "plucker"}));
  EXPECT_EQ(config.protocols.size(), 7u);
  EXPECT_EQ(config.hit_rates, (std::vector<double>{0, 0.25, 1}));
  EXPECT_EQ(config.precisions, (std::vector<Precision>{Precision::double_precision}));
  EXPECT_TRUE(config.variants.is_star);
  EXPECT_EQ(config.scenes, (std::vector<std::string>{"grotto", "chair-ball"}));
  EXPECT_EQ(config.threads, (std::vector<int>{1, 2, processors}));
  EXPECT_EQ(config.measure.rounds, 3);
  EXPECT_EQ(config.measure.samples, 4);
  EXPECT_EQ(config.measure.min_seconds, 0.5);
  EXPECT_EQ(config.measure.budget_seconds, 120);
  EXPECT_EQ(config.measure.seed, 9u);
}

TEST(kernel_config, overrides_change_it_and_its_text) {
  const KernelConfig config = parse(head, {"method=wald", "measure.rounds=5"});
  EXPECT_EQ(config.methods, (std::vector<std::string>{"wald"}));
  EXPECT_EQ(config.measure.rounds, 5);
  EXPECT_EQ(parse(config.text).methods, config.methods) << config.text;
}

TEST(kernel_config, each_bad_value_is_told_by_file_line_and_possible_values_all_at_once) {
  EXPECT_EQ(errors(head + "[scene]\n"),
            "a.toml:3: unknown key \"scene\"; possible: experiment, title, kind, sweep, measure, claim, "
            "published, quick");
  EXPECT_EQ(errors("kind = \"kernel\"\n"),
            "a.toml:1: experiment must be a name, such as \"M11-T3\"; it names the folder of the run");
  EXPECT_EQ(
      errors(head + "[sweep]\nkernel = \"expressions\"\nprotocol = \"rnadom\"\nhit_rate = [0.5, 0.33, "
                    "\"all\"]\nthreads = [0, \"many\"]\nvariants = []\nmethod = []\nvariant = 1\n"),
      "a.toml:4: unknown kernel \"expressions\"; built here: intersection, expression_templates, "
      "virtual_calls, branches, dot_products\n"
      "a.toml:10: unknown key \"sweep.variant\"; possible: kernel, method, protocol, hit_rate, precision, "
      "variants, scene, scheduler, threads\n"
      "a.toml:9: method is an empty list; name one value at least\n"
      "a.toml:5: unknown protocol \"rnadom\"; built here: random, hit-rate, worst-case, packet-common, "
      "packet-general, replay, clusters, all\n"
      "a.toml:8: variants is an empty list; name one value at least\n"
      "a.toml:6: hit_rate must be numbers from 0 to 1 in steps of 0.0125\n"
      "a.toml:6: hit_rate must be numbers from 0 to 1 in steps of 0.0125\n"
      "a.toml:7: threads must be whole numbers from 1 to 1024, or \"all\"\n"
      "a.toml:7: threads must be whole numbers from 1 to 1024, or \"all\"");
  EXPECT_EQ(errors(head + "[measure]\nrounds = 0\nmin_time = 0\nbudget = \"soon\"\nlaunches = 3\n"),
            "a.toml:7: unknown key \"measure.launches\"; possible: rounds, samples, min_time, budget, seed\n"
            "a.toml:4: rounds must be a whole number from 1 to 1000\n"
            "a.toml:5: min_time must be a number from 1e-06 to 60\n"
            "a.toml:6: budget must be a duration such as \"90 s\", \"10 min\" or \"2 h\"");
  EXPECT_EQ(errors(head + "[sweep]\nscene = [\"pebble\", \"marbles\"]\n")
                .find("a.toml:4: unknown scene \"marbles\"; built here: chair-ball, "),
            0u)
      << "a scene without triangles";
}

TEST(kernel_config, other_kernels_have_factors_of_their_own_and_no_others) {
  EXPECT_EQ(errors(head + "[sweep]\nkernel = \"branches\"\nhit_rate = [0.5, 0.33]\nbranches = \"maybe\"\n"
                          "method = \"wald\"\n"),
            "a.toml:6: unknown branches \"maybe\"; built here: yes, no, all\n"
            "a.toml:5: hit_rate must be numbers from 0 to 1 in steps of 0.0125\n"
            "a.toml:7: unknown key \"sweep.method\"; possible: kernel, branches, hit_rate");
  EXPECT_EQ(errors(head + "[sweep]\nkernel = [\"virtual_calls\", \"expression_templates\"]\n"
                          "length = [0, 2000000]\niterations = 2.5\nthreads = 2\n"),
            "a.toml:5: length must be numbers from 1 to 1000000\n"
            "a.toml:5: length must be numbers from 1 to 1000000\n"
            "a.toml:6: iterations must be numbers from 1 to 10000000 in steps of 1\n"
            "a.toml:7: unknown key \"sweep.threads\"; possible: kernel, dispatch, length, pass, vector, "
            "iterations");
  EXPECT_EQ(errors(head + "[sweep]\nkernel = [\"intersection\", \"branches\"]\n"),
            "a.toml:4: kernel \"intersection\" is an experiment of its own; name it alone");
}

TEST(kernel_plan, of_other_kernels_has_every_combination_of_their_factors) {
  const auto keys =
      keys_of(plan_of("kernel = [\"virtual_calls\", \"expression_templates\"]\n"
                      "dispatch = [\"virtual\", \"variant\"]\nlength = [10, 1000000]\n"
                      "pass = \"first\"\nvector = \"eigen\"\niterations = 10\n"));
  EXPECT_EQ(keys,
            (std::set<std::string>{"virtual_calls/virtual/10/first", "virtual_calls/virtual/1000000/first",
                                   "virtual_calls/variant/10/first", "virtual_calls/variant/1000000/first",
                                   "expression_templates/eigen/10"}));
}

TEST(kernel_plan, tells_which_ways_this_processor_does_not_have) {
  const KernelPlan plan = plan_of("kernel = \"dot_products\"\n");
  EXPECT_EQ(plan.cells.size() + plan.left_out.size(), 4u);
  EXPECT_TRUE(keys_of(plan).contains("dot_products/scalar"));
  for (const Inapplicable& one : plan.left_out) {
    EXPECT_EQ(one.method, "dot_products");
    EXPECT_TRUE(one.change == "dpps" || one.change == "shuffles") << one.change;
    EXPECT_NE(one.reason.find("SSE4.1"), std::string::npos) << one.reason;
  }
}

TEST(kernel_plan, names_each_cell_once) {
  const KernelPlan plan = plan_of(
      "method = [\"wald\", \"plucker\"]\nprotocol = \"all\"\nvariants = \"star\"\nthreads = [1, 2]\n");
  const auto keys = keys_of(plan);
  EXPECT_EQ(keys.size(), plan.cells.size());
  for (const char* key : {"wald/division=late/float/hit-rate/0.5", "plucker/base/double/random",
                          "wald/base/float/random/2 threads", "wald/base/float/replay/chair-ball",
                          "wald/output=hit/float/clusters/64", "wald/base/float/worst-case/1"})
    EXPECT_TRUE(keys.contains(key)) << key;
  EXPECT_TRUE(plan.wall_clock);
  EXPECT_EQ(to_json(plan)["cells"].size(), plan.cells.size());
  EXPECT_EQ(record_count(plan), 9 * plan.cells.size());
}

TEST(kernel_plan, of_the_worst_case_has_no_test_that_ends_early) {
  const KernelPlan star = plan_of(
      "method = \"wald\"\nprotocol = \"worst-case\"\nhit_rate = [0, 0.5]\nvariants = \"star\"\nprecision = "
      "\"float\"\n");
  const auto keys = keys_of(star);
  EXPECT_TRUE(keys.contains("wald/early_out=no/float/worst-case/0.5"));
  EXPECT_FALSE(keys.contains("wald/base/float/worst-case/0.5"));
  EXPECT_TRUE(keys.contains("wald/early_out=no/float/worst-case/1"));
  EXPECT_TRUE(keys.contains("wald/base/float/worst-case/1")) << "where all are hits, none ends early";
  const KernelPlan base =
      plan_of("method = \"wald\"\nprotocol = \"worst-case\"\nhit_rate = [0, 0.5]\nprecision = \"float\"\n");
  EXPECT_EQ(keys_of(base), (std::set<std::string>{"wald/base/float/worst-case/1"}));
}

TEST(kernel_config, takes_variants_by_what_they_change_each_once) {
  const auto changes = [](const std::string& value) {
    return parse(head + "[sweep]\nvariants = " + value + "\n").variants.changes;
  };
  EXPECT_EQ(changes("[\"base\", \"division=late\", \"base\"]"),
            (std::vector<std::string>{"base", "division=late"}));
  EXPECT_EQ(changes("\"data=bare\""), (std::vector<std::string>{"data=bare"}));
  const std::string unknown = errors(head + "[sweep]\nvariants = [\"base\",\n\"division=soon\", 3]\n");
  EXPECT_TRUE(unknown.starts_with(
      "a.toml:5: unknown variants \"division=soon\"; possible: base, star, product, division=late, "))
      << unknown;
  EXPECT_TRUE(unknown.ends_with("\na.toml:5: variants must be strings in quotes")) << unknown;
  EXPECT_EQ(errors(head + "[sweep]\nvariants = [\"base\", \"star\"]\n"),
            "a.toml:4: variants: \"star\" stands alone");
}

TEST(kernel_plan, has_the_listed_variants_alone_and_names_who_lacks_one) {
  const KernelPlan plan = plan_of(
      "method = [\"wald\", \"angle_sum\"]\nprecision = \"float\"\nvariants = [\"base\", "
      "\"division=late\"]\n");
  EXPECT_EQ(keys_of(plan), (std::set<std::string>{"wald/base/float/random", "wald/division=late/float/random",
                                                  "angle_sum/base/float/random"}));
  ASSERT_EQ(plan.left_out.size(), 1u);
  EXPECT_EQ(plan.left_out[0].method, "angle_sum");
  EXPECT_EQ(plan.left_out[0].change, "division=late");
}

TEST(kernel_plan, packets_of_rays_take_part_only_where_there_are_packets) {
  const KernelPlan plan = plan_of("protocol = [\"random\", \"packet-common\"]\nvariants = \"star\"\n");
  for (const std::string& key : keys_of(plan)) {
    const bool is_packet = key.find("/rays=") != std::string::npos;
    EXPECT_FALSE(is_packet && key.find("/packet-common") == std::string::npos) << key;
  }
}

TEST(kernel_plan, tells_which_variants_there_are_not) {
  const KernelPlan plan = plan_of("method = \"angle_sum\"\nvariants = \"star\"\nprecision = \"float\"\n");
  const bool told = std::ranges::any_of(
      plan.left_out, [](const Inapplicable& one) { return one.change == "division=late"; });
  EXPECT_TRUE(told);
  EXPECT_TRUE(plan_of("method = \"angle_sum\"\n").left_out.empty());
}

}  // namespace
}  // namespace raysweep
