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

TEST(table, latex_has_the_rules_of_booktabs_and_reads_no_text_as_a_command) {
  const Table table{
      "50 % of\nn_1 – {a}", {{"x^2 & y", false}, {"±"}}, {{"a\\b", "≤ $3"}, {"[#1~]", "1.5 µs"}}};
  EXPECT_EQ(to_latex(table),
            "\\begin{table}\n"
            "\\caption{50 \\% of; n\\_1 -- \\{a\\}}\n"
            "\\begin{tabular}{lr}\n"
            "\\toprule\n"
            "  x\\textasciicircum{}2 \\& y & $\\pm$ \\\\\n"
            "\\midrule\n"
            "  a\\textbackslash{}b & $\\le$ \\$3 \\\\\n"
            "  {[}\\#1\\textasciitilde{}] & 1.5 $\\mu$s \\\\\n"
            "\\bottomrule\n"
            "\\end{tabular}\n"
            "\\end{table}\n");
}

}  // namespace
}  // namespace raysweep
