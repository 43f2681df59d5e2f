// What methods promise and what they are expected to fail, each case at its hardest: base variants alone, the
// others and the easier levels are for contract_exhaustive_test.
#include <set>

#include "experiments/intersection/subjects.h"
#include "tests/experiments/intersection/contract_cases.h"

namespace raysweep {
namespace {

template <class T>
void keep_base_variants(AccuracyBatch& batch) {
  std::erase_if(batch.subjects, [](size_t subject) { return all_subjects<T>()[subject].change != "base"; });
}

TEST_P(ContractOf, fails_as_often_as_stated_where_the_case_is_hardest) {
  const Case& one = all_cases()[GetParam()];
  for (AccuracyBatch& batch : all_batches(one)) {
    if (batch.level + 1 < one.difficulties.size()) continue;
    if (batch.precision == Precision::float_precision) {
      keep_base_variants<float>(batch);
    } else {
      keep_base_variants<double>(batch);
    }
    expect_as_stated(batch);
  }
}
INSTANTIATE_TEST_SUITE_P(every_case, ContractOf, testing::Range(size_t{0}, all_cases().size()), case_name);

TEST(contract, has_a_clause_for_each_base_variant_on_each_case_and_of_no_other_name) {
  std::set<std::string> stated, known, cases;
  for (const Case& one : all_cases()) cases.insert(std::string(one.id));
  const auto add = [&](const auto& subjects, const std::string& precision) {
    for (const auto& s : subjects) known.insert(std::string(s.method) + ' ' + s.change + ' ' + precision);
  };
  add(all_subjects<float>(), "float");
  add(all_subjects<double>(), "double");
  size_t of_base = 0;
  for (const Clause& clause : contract().clauses()) {
    const std::string subject = clause.method + ' ' + clause.change + ' ' + clause.precision;
    EXPECT_TRUE(known.contains(subject)) << subject;
    EXPECT_TRUE(cases.contains(clause.case_id)) << clause.case_id;
    EXPECT_TRUE(stated.insert(subject + ' ' + clause.case_id).second) << subject << ' ' << clause.case_id;
    of_base += clause.change == "base";
    EXPECT_EQ(clause.t_error_classes.size(), case_of(clause.case_id).difficulties.size());
    EXPECT_EQ(clause.rays, contract().clauses().front().rays);
    EXPECT_EQ(clause.seed, contract().clauses().front().seed);
  }
  EXPECT_EQ(of_base, 2 * study_method_names().size() * cases.size());
}

/// Of Möller and Trumbore's method on the hardest W1 what a run finds, a little changed.
AccuracyRecord changed_record(int64_t by) {
  const Case& one = case_of("W1");
  const AccuracyBatch batch{&one, one.difficulties.size() - 1, Precision::float_precision, {0}};
  const Clause& any = contract().clauses().front();
  AccuracyRecord record = run_batch(batch, {"contract", any.seed, any.rays}, [] { return false; })[0];
  record.false_misses = static_cast<uint64_t>(static_cast<int64_t>(record.false_misses) + by);
  return record;
}

TEST(contract, tells_of_one_failure_more_and_of_one_less) {
  EXPECT_TRUE(differences(changed_record(0)).empty());
  ASSERT_EQ(differences(changed_record(1)).size(), 1u);
  EXPECT_NE(differences(changed_record(1))[0].find("broken"), std::string::npos);
  ASSERT_EQ(differences(changed_record(-1)).size(), 1u);
  EXPECT_NE(differences(changed_record(-1))[0].find("better"), std::string::npos);
}

}  // namespace
}  // namespace raysweep
