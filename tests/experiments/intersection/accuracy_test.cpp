// Cells of the accuracy study: the same as one method tried alone, the same each time, and all there are.
#include "experiments/intersection/accuracy.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "experiments/intersection/subjects.h"
#include "experiments/intersection/tally.h"
#include "tracer/intersect/study.h"

namespace raysweep {
namespace {

bool never() { return false; }

template <class T>
size_t subject_of(std::string_view method, std::string_view change) {
  const auto& all = all_subjects<T>();
  const auto found = std::find_if(
      all.begin(), all.end(), [&](const Subject<T>& s) { return s.method == method && s.change == change; });
  return static_cast<size_t>(found - all.begin());
}

AccuracyBatch batch_of(std::string_view id, size_t level, std::vector<size_t> subjects,
                       Precision precision = Precision::float_precision) {
  return {&case_of(id), level, precision, std::move(subjects)};
}

const AccuracySettings settings{"x", 5, 400};

TEST(accuracy, of_one_seed_gives_the_same_bytes_and_of_another_others) {
  std::vector<size_t> all(all_subjects<float>().size());
  for (size_t i = 0; i < all.size(); ++i) all[i] = i;
  const auto lines = [&](const AccuracySettings& with) {
    std::string text;
    for (AccuracyRecord& record : run_batch(batch_of("W1", 3, all), with, never)) {
      EXPECT_EQ(record.seed, with.seed);
      record.seed = 0;  // which alone would tell them apart
      text += to_line(record) + "\n";
    }
    return text;
  };
  const std::string first = lines(settings);
  EXPECT_EQ(first, lines(settings));
  AccuracySettings other = settings;
  other.seed = 6;
  EXPECT_NE(first, lines(other));
}

TEST(accuracy, of_a_cell_does_not_depend_on_what_else_is_in_its_batch) {
  const size_t wald = subject_of<float>("wald", "base"), plucker = subject_of<float>("plucker", "base");
  const auto together = run_batch(batch_of("D1", 4, {wald, plucker}), settings, never);
  const auto alone = run_batch(batch_of("D1", 4, {plucker}), settings, never);
  ASSERT_EQ(together.size(), 2u);
  EXPECT_EQ(to_line(together[1]), to_line(alone[0]));
}

template <class T>
class Accuracy : public testing::Test {};
using Reals = testing::Types<float, double>;
TYPED_TEST_SUITE(Accuracy, Reals);

TYPED_TEST(Accuracy, is_that_of_each_method_tried_alone) {
  using T = TypeParam;
  const Precision precision =
      std::is_same_v<T, float> ? Precision::float_precision : Precision::double_precision;
  const Case& one = case_of("W2");
  for_each_study_method([&]<class Method>(Method) {
    const auto method = [](const Ray<T>& ray, const Triangle<T>& triangle) {
      return solve<Method, base_variant<Method>(), T>(ray, Method::prepare(triangle),
                                                      std::numeric_limits<T>::infinity());
    };
    const Tally tally = run_case<T>(one, one.difficulties[3], 5, 400, method, base_variant<Method>().output);
    const size_t subject = subject_of<T>(Method::name, "base");
    const auto records = run_batch(batch_of("W2", 3, {subject}, precision), settings, never);
    ASSERT_EQ(records.size(), 1u);
    const AccuracyRecord& r = records[0];
    EXPECT_EQ(r.method, Method::name);
    EXPECT_EQ(r.precision, name_of(precision));
    EXPECT_EQ(r.rays, 400u);
    EXPECT_EQ(r.false_misses, tally.false_misses) << Method::name;
    EXPECT_EQ(r.false_hits, tally.false_hits) << Method::name;
    EXPECT_EQ(r.missed_rays, tally.missed_rays) << Method::name;
    EXPECT_EQ(r.boundary, tally.boundary);
    EXPECT_EQ(r.t_error.count, tally.t_error.size());
    if (r.t_error.count > 0) {
      EXPECT_EQ(r.t_error.max, Tally::summary(tally.t_error).greatest);
    }
  });
}

TYPED_TEST(Accuracy, of_every_subject_ends_rays_at_their_end) {
  using T = TypeParam;
  Trials<T> trials;
  for (const T end : {T(1), T(3)})
    trials.add({{T(0.25), T(0.25), 2}, {0, 0, -1}}, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, end);
  for (const Subject<T>& subject : all_subjects<T>()) {
    const Hits<T> hits = subject.find_hits(trials);
    ASSERT_EQ(hits.size(), 2u);
    EXPECT_FALSE(hits[0].has_value()) << subject.method << ' ' << subject.change;
    EXPECT_TRUE(hits[1].has_value()) << subject.method << ' ' << subject.change;
  }
}

TEST(accuracy, each_variant_is_a_subject_or_has_a_reason_not_to_be) {
  std::map<std::string_view, size_t> of_method;
  std::set<std::string> names;
  const auto add = [&](std::string_view method, const std::string& change, std::string_view precision) {
    ++of_method[method];
    EXPECT_TRUE(names.insert(std::string(method) + ' ' + change + ' ' + std::string(precision)).second);
  };
  for (const auto& s : all_subjects<float>()) add(s.method, s.change, "float");
  for (const auto& s : all_subjects<double>()) add(s.method, s.change, "double");
  for (const Inapplicable& one : inapplicable_subjects()) {
    EXPECT_FALSE(one.reason.empty());
    add(one.method, one.change, one.precision);
  }
  EXPECT_EQ(of_method.size(), study_method_names().size());
  for (const auto& [method, count] : of_method) EXPECT_EQ(count, 2 * 11u) << method;
}

TEST(accuracy, of_variants_that_give_less_has_the_same_decisions_and_no_number_that_is_missing) {
  const Case& one = case_of("W1");
  for (const Subject<float>& subject : all_subjects<float>()) {
    if (!subject.change.starts_with("output=")) continue;
    const auto records = run_batch(batch_of("W1", one.difficulties.size() - 1,
                                            {subject_of<float>(subject.method, "base"),
                                             subject_of<float>(subject.method, subject.change)}),
                                   settings, never);
    ASSERT_EQ(records.size(), 2u);
    EXPECT_EQ(records[0].false_misses, records[1].false_misses) << subject.method << ' ' << subject.change;
    EXPECT_EQ(records[0].false_hits, records[1].false_hits) << subject.method << ' ' << subject.change;
    EXPECT_EQ(records[1].nonfinite, 0u) << subject.method << ' ' << subject.change;
    EXPECT_EQ(records[1].uv_error.count, 0u);
    EXPECT_EQ(records[1].t_error.count == 0, subject.variant.output == Output::hit);
  }
}

TEST(accuracy, stops_between_cells_when_told) {
  static int calls;
  calls = 0;
  const auto after_two = [] { return ++calls > 3; };  // before the trials, and before each cell
  EXPECT_EQ(run_batch(batch_of("S1", 0, {0, 1, 2, 3}), settings, after_two).size(), 2u);
}

TEST(accuracy, cells_have_keys_that_tell_what_they_are) {
  const size_t late = subject_of<float>("moller_trumbore", "division=late");
  EXPECT_EQ(cell_key(batch_of("S1", 4, {late}), late), "moller_trumbore/division=late/float/S1/0.0002");
}

}  // namespace
}  // namespace raysweep
