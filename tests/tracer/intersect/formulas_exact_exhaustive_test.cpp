// The rationals' test with more pairs: rare ones come too.
#include "tests/tracer/intersect/cramers_rule.h"

namespace raysweep {
namespace {

TEST(formulas_exact_exhaustive, every_variant_of_every_method_is_cramers_rule) {
  expect_cramers_rule(2, 100'000);
}

}  // namespace
}  // namespace raysweep
