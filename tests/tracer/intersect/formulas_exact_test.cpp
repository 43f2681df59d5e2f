// Without rounding every formula is Cramer's rule: what differs here is a wrong formula.
#include "tests/tracer/intersect/cramers_rule.h"

namespace raysweep {
namespace {

TEST(formulas_exact, every_variant_of_every_method_is_cramers_rule) {
  expect_cramers_rule<WhichVariants::star>(1, 2000);
}

}  // namespace
}  // namespace raysweep
