// Formulas of the machine.
#include "results/claims/expression.h"

#include <gtest/gtest.h>

namespace raysweep {
namespace {

constexpr MachineCounts morozov{6, 12}, plain{2, 2};

std::string complaint(const std::string& text, const MachineCounts& machine = morozov) {
  try {
    return std::to_string(evaluate(text, machine));
  } catch (const ExpressionError& error) {
    return error.what();
  }
}

TEST(expressions, count_cores_processors_and_hyper_threading) {
  EXPECT_EQ(evaluate("12", morozov), 12);
  EXPECT_EQ(evaluate("2*pus", morozov), 24);
  EXPECT_DOUBLE_EQ(evaluate("0.9*cores", morozov), 5.4);
  EXPECT_EQ(evaluate("smt", morozov), 1);
  EXPECT_EQ(evaluate("smt", plain), 0);
}

TEST(expressions, join_conditions_by_and_and_or) {
  EXPECT_EQ(evaluate("cores >= 6 and smt", morozov), 1);
  EXPECT_EQ(evaluate("cores >= 6 and smt", plain), 0);
  EXPECT_EQ(evaluate("cores >= 6 or pus == 2", plain), 1);
  EXPECT_EQ(evaluate("cores >= 8 or smt and pus > 13", morozov), 0);
}

TEST(expressions, of_what_is_no_formula_tell_so) {
  for (const std::string text : {"cores >= six", "cores = 6", ""}) {
    const std::string begin = "\"" + text + "\" is no formula of cores, pus and smt: ";
    EXPECT_EQ(complaint(text).substr(0, begin.size()), begin);
  }
  EXPECT_EQ(complaint("1/(pus-12)"), "\"1/(pus-12)\" comes to no number");
  EXPECT_EQ(complaint("2*pus", {}), "\"2*pus\" needs a machine whose cores are known");
}

TEST(expressions, only_whole_words_are_of_the_machine) {
  EXPECT_TRUE(mentions_machine("2*pus"));
  EXPECT_FALSE(mentions_machine("scores"));
  EXPECT_FALSE(mentions_machine("3/thread"));
}

}  // namespace
}  // namespace raysweep
