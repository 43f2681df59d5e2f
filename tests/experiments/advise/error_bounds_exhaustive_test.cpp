// The laws of error on fifty times as many rays.
#include <gtest/gtest.h>

#include "tests/experiments/advise/laws_hold.h"

namespace raysweep {
namespace {

TEST(error_laws, no_hit_of_the_catalogue_errs_by_more_than_its_law_says_in_float) {
  EXPECT_GT(check_all_laws<float>(3000).hits, 4'000'000u);
}

TEST(error_laws, no_hit_of_the_catalogue_errs_by_more_than_its_law_says_in_double) {
  EXPECT_GT(check_all_laws<double>(3000).hits, 4'000'000u);
}

}  // namespace
}  // namespace raysweep
