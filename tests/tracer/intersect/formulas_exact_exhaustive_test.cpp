// The rationals' test with a hundred thousand pairs: rare ones come too.
#include "tests/tracer/intersect/cramers_rule.h"

namespace raysweep {
namespace {

TEST(formulas_exact_exhaustive, every_method_is_cramers_rule) {
  expect_cramers_rule<WhichVariants::base>(2, 100'000);
}

}  // namespace
}  // namespace raysweep
