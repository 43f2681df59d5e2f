#include "results/tables/table.h"

#include <gtest/gtest.h>

namespace raysweep {
namespace {

Table example() { return {"A caption", {{"name", false}, {"fps"}}, {{"a \"b\", c", "1.5"}, {"–", "10"}}}; }

TEST(table, text_is_aligned_by_what_is_seen) {
  EXPECT_EQ(to_text(example()),
            "A caption\n"
            "name      fps\n"
            "────────  ───\n"
            "a \"b\", c  1.5\n"
            "–          10\n");
}

TEST(table, markdown_has_a_rule_with_alignment) {
  EXPECT_EQ(to_markdown(example()),
            "A caption\n\n"
            "| name     | fps |\n"
            "|----------|----:|\n"
            "| a \"b\", c | 1.5 |\n"
            "| –        |  10 |\n");
}

TEST(table, csv_quotes_what_needs_it) {
  EXPECT_EQ(to_csv(example()), "name,fps\n\"a \"\"b\"\", c\",1.5\n–,10\n");
}

}  // namespace
}  // namespace raysweep
