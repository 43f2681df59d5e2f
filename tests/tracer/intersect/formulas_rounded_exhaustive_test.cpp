// The test of rounded values with ten million pairs.
#include "tests/tracer/intersect/near_values.h"

namespace raysweep {
namespace {

TEST(formulas_rounded_exhaustive, every_method_in_double_is_right_but_for_rounding) {
  expect_near_values<WhichVariants::base, double>(3, 10'000'000);
}

TEST(formulas_rounded_exhaustive, every_method_in_float_is_right_but_for_rounding) {
  expect_near_values<WhichVariants::base, float>(4, 10'000'000);
}

}  // namespace
}  // namespace raysweep
