// All that the contract states: every variant of every method on every case at every level.
#include "tests/experiments/intersection/contract_cases.h"

namespace raysweep {
namespace {

TEST_P(ContractOf, every_variant_fails_as_often_as_stated_at_every_level) {
  for (const AccuracyBatch& batch : all_batches(all_cases()[GetParam()])) expect_as_stated(batch);
}
INSTANTIATE_TEST_SUITE_P(every_case, ContractOf, testing::Range(size_t{0}, all_cases().size()), case_name);

}  // namespace
}  // namespace raysweep
