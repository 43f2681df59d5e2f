// What advice makes of predictions and times; and what it predicts of scenes.
#include "experiments/advise/advice.h"

#include <gtest/gtest.h>

#include <limits>

#include "experiments/advise/advisor.h"
#include "experiments/errors.h"
#include "tracer/scene/scenes.h"

namespace raysweep {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

Advised line(std::string_view method, double bound, std::vector<double> nanoseconds) {
  return {{{method, "float"}, bound}, {}, std::move(nanoseconds)};
}
std::vector<double> rounds_of(double nanoseconds) {
  return {nanoseconds, nanoseconds, nanoseconds, nanoseconds, nanoseconds, nanoseconds, nanoseconds};
}

TEST(advice, is_the_quickest_of_those_that_keep_the_tolerance) {
  const std::vector<Advised> all{line("a", 1e-3, rounds_of(1)), line("b", 1e-6, rounds_of(4)),
                                 line("c", 1e-4, rounds_of(3)), line("d", 1e-5, rounds_of(2))};
  const Ranking ranking = rank(all, 1e-4);
  EXPECT_EQ(ranking.choice, 3u);
  EXPECT_EQ(ranking.runner_up, 2u);
  EXPECT_EQ(advice_text(all, ranking, 1e-4),
            "Take d in float: of what keeps a hit tolerance of 0.0001 it takes least time. Next is c in "
            "float, +50.0 % [50.0, 50.0].");
}

TEST(advice, says_where_no_difference_is_shown) {
  const std::vector<Advised> all{line("a", 1e-6, {10, 10, 10, 10, 10, 10, 10}),
                                 line("b", 1e-6, {9, 9, 9, 11, 11, 11, 11})};
  EXPECT_EQ(advice_text(all, rank(all, 1e-4), 1e-4),
            "Take a in float: of what keeps a hit tolerance of 0.0001 it takes least time. Next is b in "
            "float, +10.0 % [-10.0, 10.0]: no difference shown; at most 11.1 % slower than any of them.");
}

TEST(advice, tells_how_much_slower_than_any_other_that_keeps_the_tolerance_a_choice_may_be) {
  const std::vector<Advised> all{line("a", 1e-6, {10, 10, 10, 10, 10, 10, 10}),
                                 line("b", 1e-6, {9, 9, 9, 11, 11, 11, 11}),
                                 line("c", 1e-6, {9.6, 12, 12, 12, 12, 12, 12}), line("d", 1, rounds_of(1))};
  const Ranking ranking = rank(all, 1e-4);
  ASSERT_EQ(ranking.choice, 0u);
  EXPECT_NEAR(*most_slower(all, ranking, 1e-4), 10.0 / 9 - 1, 1e-12) << "d is quicker, but keeps nothing";
  EXPECT_EQ(most_slower({all[0], all[3]}, {0, {}}, 1e-4), 0);
  EXPECT_FALSE(most_slower(all, {}, 1e-4));
  EXPECT_FALSE(most_slower({line("a", 0, {1, 1}), line("b", 0, {2, 2})}, {0, 1}, 1e-4)) << "too few rounds";
}

/// Small pictures in no more rounds than there must be.
AdviceRequest quick_request() {
  AdviceRequest request;
  request.settings.width = 16;
  request.settings.height = 12;
  request.rounds.seconds = request.rounds.longest = 0;
  return request;
}

TEST(advice, is_given_when_its_time_is_over_certain_or_not) {
  const Advice advice = advise(load_scene("chair-ball"), quick_request());
  EXPECT_EQ(advice.all.front().nanoseconds.size(), static_cast<size_t>(quick_request().rounds.least));
}

TEST(advice, rounds_go_on_until_they_tell_enough) {
  AdviceRequest request = quick_request();
  request.rounds.longest = std::numeric_limits<double>::infinity();
  const Scene scene = load_scene("cornell-glass");
  PictureRace race(scene, {request.settings, request.settings}, request.rounds);
  std::vector<size_t> asked_after;
  const RoundTimes times = race.run([&](const RoundTimes& so_far) {
    asked_after.push_back(so_far[1].size());
    return asked_after.size() == 3;
  });
  EXPECT_EQ(asked_after, (std::vector<size_t>{7, 8, 9}));
  EXPECT_EQ(times.size(), 2u);
  EXPECT_EQ(times[0].size(), 9u);
}

// Of this scene's hits `morozov`'s keep 1e-6 by so little that a few thousand do not tell.
TEST(advice, is_measured_on_more_hits_where_a_tolerance_is_nearly_the_error) {
  const Scene scene = load_scene("chair-ball");
  AdviceRequest request = quick_request();
  request.settings.core = "wide";
  const Advice clear = advise(scene, request);
  request.tolerance = 1e-6;
  const Advice close = advise(scene, request);
  EXPECT_GT(close.measured_hits, 10 * clear.measured_hits);
  EXPECT_EQ(close.predicted_hits, clear.predicted_hits);
}

TEST(advice, names_what_is_the_only_one) {
  const std::vector<Advised> all{line("a", 1e-3, rounds_of(1)), line("b", 1e-6, rounds_of(4))};
  const Ranking ranking = rank(all, 1e-5);
  EXPECT_EQ(ranking.choice, 1u);
  EXPECT_FALSE(ranking.runner_up);
  EXPECT_EQ(advice_text(all, ranking, 1e-5), "Take b in float: nothing else keeps a hit tolerance of 1e-05.");
}

TEST(advice, takes_what_is_measured_to_keep_the_tolerance_and_says_so) {
  std::vector<Advised> all{line("a", 1e-3, rounds_of(1)), line("b", 1e-6, rounds_of(4))};
  all[0].measured = {.error = 1e-7, .missed = 0, .shown = 2e-6};
  EXPECT_EQ(rank(all, 2e-6).choice, 0u);
  EXPECT_EQ(rank(all, 1.9e-6).choice, 1u);
  EXPECT_EQ(
      advice_text(all, rank(all, 1e-5), 1e-5),
      "Take a in float: of what keeps a hit tolerance of 1e-05 it takes least time. That it keeps it is "
      "measured, at 95 %, not promised. Next is b in float, +300.0 % [300.0, 300.0].");
}

TEST(advice, errors_of_too_few_hits_show_nothing) {
  const double none = std::numeric_limits<double>::infinity();
  std::vector<double> errors(2994, 1.0);
  EXPECT_EQ(shown_error(errors), none);
  errors.push_back(2.0);
  EXPECT_EQ(shown_error(errors), 2.0) << "the greatest of 2995";
  errors.resize(10'000, 1.0);
  for (int i = 0; i < 4; ++i) errors[static_cast<size_t>(i)] = none;
  EXPECT_EQ(shown_error(errors), 2.0) << "four of ten thousand may be beyond it";
  errors[4] = none;
  EXPECT_EQ(shown_error(errors), none);
  EXPECT_EQ(shown_error({}), 0);
}

TEST(advice, refuses_with_the_smallest_tolerance_that_can_be_promised) {
  const std::vector<Advised> all{line("a", infinite, rounds_of(1)), line("b", 3.14e-6, rounds_of(4))};
  const Ranking ranking = rank(all, 1e-7);
  EXPECT_FALSE(ranking.choice);
  EXPECT_EQ(advice_text(all, ranking, 1e-7),
            "no method can promise a hit tolerance of 1e-07; the smallest that can be is 3.2e-06, by b in "
            "float, and none is measured to keep it.");
  EXPECT_TRUE(rank(all, 3.2e-6).choice) << "what it says can be promised is";
  EXPECT_EQ(refusal({{{"a", "float"}, infinite}}, 0.5),
            "no method can promise a hit tolerance of 0.5, nor any other: more than one hit in a thousand is "
            "on a triangle too thin, or by a ray too flat, for its numbers");
}

TEST(advice, the_first_that_keeps_a_tolerance_is_the_cheapest_one) {
  const std::vector<Prediction> all{{{"a", "float"}, 1e-3}, {{"b", "float"}, 1e-5}, {{"c", "double"}, 1e-9}};
  EXPECT_EQ(first_that_keeps(all, 1e-3)->choice.method, "a");
  EXPECT_EQ(first_that_keeps(all, 1e-4)->choice.method, "b");
  EXPECT_EQ(first_that_keeps(all, 1e-8)->choice.method, "c");
  EXPECT_FALSE(first_that_keeps(all, 1e-10));
}

TEST(advice, tolerances_are_shares_of_the_scene_s_size) {
  EXPECT_EQ(tolerance_problem(1e-4), "");
  EXPECT_EQ(tolerance_problem(1), "");
  for (const double bad : {0.0, -1e-4, 1.1, infinite, std::numeric_limits<double>::quiet_NaN()})
    EXPECT_NE(tolerance_problem(bad), "") << bad;
  EXPECT_EQ(
      tolerance_problem(2),
      "hit-tolerance = 2 is not possible: a number above 0 and up to 1, the share of the scene's size by "
      "which hit points may be off");
}

TEST(advice, offers_every_method_in_every_precision_of_the_core) {
  EXPECT_EQ(choices_by_cost("scalar").size(), methods().size() * precisions().size());
  EXPECT_EQ(choices_by_cost("wide").size(), methods().size());
  for (const MethodChoice& choice : choices_by_cost("wide")) EXPECT_EQ(choice.precision, "float");
}

TEST(advice, all_but_one_in_a_thousand_keep_the_error_that_is_told) {
  std::vector<double> errors;
  for (int i = 0; i < 2000; ++i) errors.push_back(i < 2 ? infinite : i);
  EXPECT_EQ(kept_error(errors), 1999);
  errors[2] = infinite;
  EXPECT_TRUE(std::isinf(kept_error(errors)));
  EXPECT_EQ(kept_error({}), 0);
  EXPECT_EQ(kept_error({5}), 5);
}

/// Scenes that are made in no time, of large, small, thin and many triangles.
constexpr const char* quick_scenes[] = {"chair-ball", "cornell-glass", "ice"};

TEST(advice, what_is_predicted_from_some_rays_of_a_scene_bounds_what_others_do) {
  for (const char* name : quick_scenes) {
    const Scene scene = load_scene(name);
    const auto samples = sample_hits(scene, {predicted_sample, measured_sample});
    EXPECT_GT(samples[0].size(), 500u) << name;
    EXPECT_GT(samples[1].size(), samples[0].size()) << name;
    for (const MethodChoice& choice : choices_by_cost("scalar")) {
      const double bound = predicted_error(choice.method, choice.precision, samples[0]);
      const Measurement measured = measured_error(choice.method, choice.precision, samples[1]);
      EXPECT_GT(measured.error, 0);
      EXPECT_GE(bound, measured.error) << name << ": " << choice.method << " in " << choice.precision;
    }
  }
}

TEST(advice, a_smaller_tolerance_takes_more_digits_and_an_impossible_one_is_refused) {
  const Scene scene = load_scene("chair-ball");
  EXPECT_EQ(choose_method(scene, "scalar", "", 1e-3).choice.precision, "float");
  EXPECT_EQ(choose_method(scene, "scalar", "", 1e-8).choice.precision, "double");
  EXPECT_EQ(choose_method(scene, "scalar", "double", 1e-3).choice.precision, "double");
  EXPECT_THROW((void)choose_method(scene, "wide", "", 1e-8), RequestError);
  EXPECT_THROW((void)choose_method(scene, "scalar", "float", 1e-8), RequestError);
  EXPECT_THROW((void)choose_method(scene, "scalar", "", 1e-18), RequestError);
}

TEST(advice, a_scene_without_triangles_keeps_every_tolerance) {
  const Prediction choice = choose_method(load_scene("marbles"), "scalar", "", 1e-18);
  EXPECT_EQ(choice.bound, 0);
  EXPECT_EQ(choice.choice, choices_by_cost("scalar").front());
}

}  // namespace
}  // namespace raysweep
