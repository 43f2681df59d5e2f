#include "experiments/intersection/run_subjects.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "experiments/intersection/kernel_modules.h"
#include "experiments/intersection/tally.h"

namespace raysweep {
namespace {

template <class T>
const Subject<T>* subject_of(std::string_view method, std::string_view change) {
  for (const Subject<T>& one : run_subjects<T>()) {
    if (one.method == method && one.change == change) return &one;
  }
  return nullptr;
}

template <class T>
Tally tally_of_subject(const Subject<T>& subject, const char* id, double difficulty) {
  const JudgedTrials<T> judged(case_of(id), difficulty, 1, 20'000);
  return tally_of(judged, subject.find_hits(judged.trials), subject.variant.output);
}

TEST(run_subjects, begin_with_those_of_every_machine) {
  const auto& all = all_subjects<float>();
  const auto& here = run_subjects<float>();
  ASSERT_GE(here.size(), all.size());
  for (size_t i = 0; i < all.size(); ++i) {
    EXPECT_EQ(here[i].method, all[i].method);
    EXPECT_EQ(here[i].change, all[i].change);
  }
}

TEST(run_subjects, are_there_or_left_out_with_a_reason) {
  for (const std::string_view method : study_method_names()) {
    for (const std::string_view change : {"contraction=on", "compiler=other"}) {
      size_t reasons = 0;
      for (const Inapplicable& one : inapplicable_here())
        reasons += one.method == method && one.change == change && !one.reason.empty() ? 1 : 0;
      EXPECT_EQ(reasons, subject_of<float>(method, change) ? 0u : 2u) << method << " " << change;
    }
  }
}

// Rays with several candidates, some without: what a kernel is asked in its own order comes back in theirs.
TEST(run_subjects, by_kernels_hit_what_the_same_variants_hit) {
  const Trials<double> trials = case_of("W1").make<double>(0, 3, 500);
  for (const Kernel<double>& kernel : all_kernels<double>()) {
    const Subject<double>* const subject = subject_of<double>(kernel.method, kernel.change);
    if (!subject || kernel.contraction == "on") continue;
    SCOPED_TRACE(fmt::format("{} {}", kernel.method, kernel.change));
    const Hits<double> some = hits_by(kernel, trials), others = subject->find_hits(trials);
    ASSERT_EQ(some.size(), others.size());
    for (size_t i = 0; i < some.size(); ++i) {
      ASSERT_EQ(some[i].has_value(), others[i].has_value()) << i;
      if (!some[i] || kernel.variant.output == Output::hit) continue;
      ASSERT_EQ(some[i]->t, others[i]->t) << i;
    }
  }
}

// The catalogue's W8: the formula is watertight by its products' rounding, which contraction takes away from
// one of two. Expected to fail, so that a compiler that does not contract would show as well.
TEST(run_subjects, w8_contraction_opens_the_edges_of_the_watertight_formula) {
  const auto* const contracted = subject_of<float>("woop_watertight", "contraction=on");
  if (!contracted) GTEST_SKIP() << "the module of contracted kernels " << why_no_kernels("contracted");
  EXPECT_EQ(tally_of_subject(*subject_of<float>("woop_watertight", "base"), "W1", 0).missed_rays, 0u);
  EXPECT_GT(tally_of_subject(*contracted, "W1", 0).missed_rays, 0u);
}

}  // namespace
}  // namespace raysweep
