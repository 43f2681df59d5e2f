// The rationals' test with a hundred thousand pairs: rare ones come too.
#include "tests/tracer/intersect/cramers_rule.h"

namespace raysweep {
namespace {

/// A quarter of the pairs each: all at once come near the time that a test may take.
class FormulasExactExhaustive : public testing::TestWithParam<uint64_t> {};

TEST_P(FormulasExactExhaustive, every_variant_of_every_method_is_cramers_rule) {
  expect_cramers_rule(GetParam(), 25'000);
}
INSTANTIATE_TEST_SUITE_P(Seeds, FormulasExactExhaustive, testing::Values(2, 3, 4, 5));

}  // namespace
}  // namespace raysweep
