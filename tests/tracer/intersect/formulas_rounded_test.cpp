// Away from edges every variant of every method decides as whole numbers do, and its values are near.
#include "tests/tracer/intersect/near_values.h"

namespace raysweep {
namespace {

TEST(formulas_rounded, every_variant_in_double_is_right_but_for_rounding) {
  expect_near_values<WhichVariants::star, double>(1, 100'000);
}

TEST(formulas_rounded, every_variant_in_float_is_right_but_for_rounding) {
  expect_near_values<WhichVariants::star, float>(2, 100'000);
}

}  // namespace
}  // namespace raysweep
