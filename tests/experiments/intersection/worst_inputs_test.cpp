// The worst inputs that searches have found: methods are as wrong there as they were, and searches do find.
#include "experiments/intersection/worst_inputs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>
#include <stdexcept>

namespace raysweep {
namespace {

const std::filesystem::path kept_file =
    RAYSWEEP_SOURCE_DIR "/tests/experiments/intersection/worst_inputs.csv";

TEST(worst_inputs, are_as_wrong_as_when_they_were_found) {
  const std::vector<WorstInput> kept = read_worst_inputs(kept_file);
  ASSERT_FALSE(kept.empty());
  for (const WorstInput& input : kept) EXPECT_EQ(to_line(judged_anew(input)), to_line(input));
}

TEST(worst_inputs, are_of_every_suspect) {
  std::set<std::string> suspects, found;
  for (const auto& s : all_suspects<float>()) suspects.insert(s.method + ' ' + s.change);
  for (const WorstInput& input : read_worst_inputs(kept_file)) {
    if (input.what == Wrong::t_error) found.insert(input.method + ' ' + input.change);
  }
  EXPECT_EQ(found, suspects);
}

TEST(worst_inputs, have_leaks_but_none_of_what_is_watertight) {
  size_t leaks = 0;
  for (const WorstInput& input : read_worst_inputs(kept_file)) {
    if (input.what != Wrong::leak) continue;
    ++leaks;
    EXPECT_NE(input.method, "woop_watertight") << to_line(input);
  }
  EXPECT_GT(leaks, 10u);
}

template <class T>
Hits<T> never(const Trials<T>& trials) {
  return Hits<T>(trials.candidates.size());
}

/// The oracle with every weight moved by `by` before it is decided.
template <class T>
Hits<T> shifted(const Trials<T>& trials, T by) {
  return hits_of(trials, [&](const Trial<T>& trial, uint32_t triangle) -> std::optional<TriangleHit<T>> {
    const ExactHit exact = exact_hit(trial.ray, trials.triangles[triangle]);
    const T beta = static_cast<T>(exact.beta) + by, gamma = static_cast<T>(exact.gamma) + by;
    if (!(exact.t > 0 && beta >= 0 && gamma >= 0 && beta + gamma <= 1)) return {};
    return TriangleHit<T>{static_cast<T>(exact.t), beta, gamma};
  });
}

SearchSettings searching(Wrong what) {
  SearchSettings settings;
  settings.what = what;
  settings.starts = 4;
  return settings;
}

template <class T>
class Search : public testing::Test {};
using Reals = testing::Types<float, double>;
TYPED_TEST_SUITE(Search, Reals);

TYPED_TEST(Search, finds_how_deep_a_method_misses_that_never_hits) {
  using T = TypeParam;
  const auto worst = search_worst<T>(never<T>, searching(Wrong::false_miss));
  ASSERT_TRUE(worst);
  EXPECT_TRUE(worst->badness.is_wrong);
  EXPECT_GT(worst->badness.how_much, 0.32) << "the middle is a third from all edges";
  EXPECT_LE(worst->badness.how_much, 1.0 / 3);
}

TYPED_TEST(Search, finds_how_far_a_method_misses_that_is_off_by_a_thousandth) {
  using T = TypeParam;
  const auto off = [](const Trials<T>& trials) { return shifted<T>(trials, T(-0x1p-10)); };
  const auto miss = search_worst<T>(off, searching(Wrong::false_miss));
  ASSERT_TRUE(miss);
  EXPECT_NEAR(miss->badness.how_much, 0x1p-10, 0x1p-12);
  const auto hit = search_worst<T>(off, searching(Wrong::false_hit));
  ASSERT_TRUE(hit);
  EXPECT_NEAR(hit->badness.how_much, 0x1p-9, 0x1p-11) << "beyond the edge BC both weights are off";
  const auto weight = search_worst<T>(off, searching(Wrong::weight_error));
  ASSERT_TRUE(weight);
  const double in_epsilon = 0x1p-10 / static_cast<double>(std::numeric_limits<T>::epsilon());
  EXPECT_NEAR(weight->badness.how_much, in_epsilon, 2);
}

TYPED_TEST(Search, finds_nothing_wrong_with_the_oracle_but_its_rounding) {
  using T = TypeParam;
  const auto exact = [](const Trials<T>& trials) {
    return hits_of(trials, [&](const Trial<T>& trial, uint32_t triangle) -> std::optional<TriangleHit<T>> {
      const ExactHit hit = exact_hit(trial.ray, trials.triangles[triangle]);
      if (hit.verdict == ExactVerdict::miss || std::isnan(hit.t)) return {};
      return TriangleHit<T>{static_cast<T>(hit.t), static_cast<T>(hit.beta), static_cast<T>(hit.gamma)};
    });
  };
  for (const Wrong what : {Wrong::false_miss, Wrong::false_hit, Wrong::leak}) {
    const auto worst = search_worst<T>(exact, searching(what));
    ASSERT_TRUE(worst);
    EXPECT_FALSE(worst->badness.is_wrong) << wrong_names[static_cast<size_t>(what)];
    EXPECT_GT(worst->badness.how_much, -1e-3) << "climbs to the edge";
  }
  EXPECT_LE(search_worst<T>(exact, searching(Wrong::t_error))->badness.how_much, 0.5);
  EXPECT_LE(search_worst<T>(exact, searching(Wrong::weight_error))->badness.how_much, 0.25);
}

TYPED_TEST(Search, finds_the_same_again_and_stays_in_its_domain) {
  using T = TypeParam;
  for (const Suspect<T>& suspect : all_suspects<T>()) {
    SearchSettings settings = searching(Wrong::leak);
    settings.starts = 1;
    settings.most_steps = 20;
    const auto first = search_worst<T>(suspect.find, settings),
               second = search_worst<T>(suspect.find, settings);
    ASSERT_TRUE(first && second) << suspect.method;
    EXPECT_EQ(first->badness, second->badness);
    EXPECT_EQ(first->question.ray.origin, second->question.ray.origin);
    EXPECT_TRUE(is_in(Domain::tame, first->question));
  }
}

TYPED_TEST(Search, finds_leaks_of_all_that_the_tracer_has_but_of_what_is_watertight) {
  using T = TypeParam;
  for (const Suspect<T>& suspect : all_suspects<T>()) {
    if (suspect.change != "intersect") continue;
    SearchSettings settings = searching(Wrong::leak);
    settings.mutants = 16;
    const auto worst = search_worst<T>(suspect.find, settings);
    ASSERT_TRUE(worst) << suspect.method;
    EXPECT_EQ(worst->badness.is_wrong, suspect.method != "woop_watertight") << suspect.method;
  }
}

TEST(search, asks_of_tame_inputs_that_nothing_is_of_another_magnitude) {
  const Question<double> tame{{{0.25, 0.25, 2}, {0, 0, -1}}, {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}};
  EXPECT_TRUE(is_in(Domain::tame, tame));
  const auto changed = [&](auto change) {
    Question<double> question = tame;
    change(question);
    EXPECT_TRUE(is_in(Domain::any, question));
    return is_in(Domain::tame, question);
  };
  EXPECT_FALSE(changed([](auto& q) { q.ray.origin.z = 9; })) << "far";
  EXPECT_FALSE(changed([](auto& q) { q.ray.origin.z = 0.2; })) << "near";
  EXPECT_FALSE(changed([](auto& q) { q.ray.direction.z = -3; })) << "a long direction";
  EXPECT_FALSE(changed([](auto& q) { q.ray.direction.z = -0.4; })) << "a short direction";
  EXPECT_FALSE(changed([](auto& q) { q.ray.direction = {1, 0, -0.1}; })) << "grazing";
  EXPECT_FALSE(changed([](auto& q) { q.triangles[0].c.y = 0.1; })) << "a needle";
  EXPECT_FALSE(changed([](auto& q) { q.triangles[0] = {{0, 0, 0}, {0.1, 0, 0}, {0, 0.1, 0}}; })) << "small";
  Question<double> infinite = tame;
  infinite.ray.origin.x = std::numeric_limits<double>::infinity();
  EXPECT_FALSE(is_in(Domain::any, infinite));
}

TEST(search, takes_for_a_leak_only_what_passes_away_from_the_ends_of_the_shared_edge) {
  Question<float> question{{{0, 0.5F, 1}, {0, 0, -1}},
                           {{{0, 0, 0}, {0, 1, 0}, {-1, 0, 0}}, {{0, 1, 0}, {0, 0, 0}, {1, 0, 0}}}};
  const Hits<float> none(2);
  const Hits<float> one{TriangleHit<float>{1, 0.5F, 0}, std::nullopt};
  EXPECT_EQ(badness_of(Wrong::leak, question, none), (Badness{true, 0}));
  EXPECT_FALSE(badness_of(Wrong::leak, question, one).is_wrong);
  question.ray.origin.x = 0.125F;
  EXPECT_EQ(badness_of(Wrong::leak, question, none), (Badness{true, 0.125}));
  EXPECT_EQ(badness_of(Wrong::leak, question, one), (Badness{false, -0.125}));
  question.ray.origin = {0, 0.01F, 1};
  EXPECT_EQ(badness_of(Wrong::leak, question, none), not_asked()) << "at a corner";
  question.ray.origin = {2, 0.5F, 1};
  EXPECT_EQ(badness_of(Wrong::leak, question, none), not_asked()) << "beside both";
  question.ray.origin = {-0.125F, 0.5F, 1};
  question.triangles[1].c = {-1, 0, 0.5F};
  EXPECT_EQ(badness_of(Wrong::leak, question, none), not_asked()) << "both on the left";
}

}  // namespace
}  // namespace raysweep
