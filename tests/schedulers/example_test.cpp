// The README's example is a file that compiles, and a scheduler that keeps the contract.
#include <algorithm>
#include <fstream>
#include <sstream>

#include "tests/schedulers/conformance.h"
#include "tests/schedulers/example_scheduler.h"

namespace raysweep {
namespace {

std::string text_of(const std::string& file) {
  std::ifstream in(std::string(RAYSWEEP_SOURCE_DIR) + "/" + file);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

std::unique_ptr<Scheduler> make_example(int threads) { return make_both_ends({.threads = threads}); }

TEST(example, every_item_runs_exactly_once) { expect_every_item_runs_exactly_once(make_example); }

TEST(example, the_first_error_reaches_the_caller) { expect_the_first_error_reaches_the_caller(make_example); }

TEST(example, is_in_the_readme_word_for_word_and_under_60_lines) {
  const std::string code = text_of("tests/schedulers/example_scheduler.cpp");
  ASSERT_FALSE(code.empty());
  EXPECT_LT(std::ranges::count(code, '\n'), 60);
  EXPECT_NE(text_of("schedulers/README.md").find("```cpp\n" + code + "```\n"), std::string::npos)
      << "schedulers/README.md shows another text than tests/schedulers/example_scheduler.cpp";
}

}  // namespace
}  // namespace raysweep
