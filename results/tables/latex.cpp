#include <fmt/format.h>

#include <array>
#include <string_view>
#include <utility>

#include "results/tables/table.h"

namespace raysweep {

namespace {

using Spelling = std::pair<std::string_view, std::string_view>;

// What LaTeX reads as a command, and what its usual fonts lack.
constexpr std::array spellings{
    Spelling{"\\", "\\textbackslash{}"},
    Spelling{"&", "\\&"},
    Spelling{"%", "\\%"},
    Spelling{"$", "\\$"},
    Spelling{"#", "\\#"},
    Spelling{"_", "\\_"},
    Spelling{"{", "\\{"},
    Spelling{"}", "\\}"},
    Spelling{"[", "{[}"},  // after the end of a row it would begin a length
    Spelling{"~", "\\textasciitilde{}"},
    Spelling{"^", "\\textasciicircum{}"},
    Spelling{"<", "$<$"},
    Spelling{">", "$>$"},
    Spelling{"–", "--"},
    Spelling{"−", "$-$"},
    Spelling{"×", "$\\times$"},
    Spelling{"·", "$\\cdot$"},
    Spelling{"±", "$\\pm$"},
    Spelling{"→", "$\\to$"},
    Spelling{"≤", "$\\le$"},
    Spelling{"≥", "$\\ge$"},
    Spelling{"≈", "$\\approx$"},
    Spelling{"∞", "$\\infty$"},
    Spelling{"√", "$\\surd$"},
    Spelling{"½", "$1/2$"},
    Spelling{"²", "$^2$"},
    Spelling{"³", "$^3$"},
    Spelling{"µ", "$\\mu$"},
    Spelling{"σ", "$\\sigma$"},
    Spelling{"κ", "$\\kappa$"},
    Spelling{"λ", "$\\lambda$"},
    Spelling{"ε", "$\\varepsilon$"},
    Spelling{"β", "$\\beta$"},
    Spelling{"γ", "$\\gamma$"},
    Spelling{"Σ", "$\\Sigma$"},
    Spelling{"…", "\\dots{}"},
    Spelling{"\n", "; "},
};

std::string escaped(std::string_view text) {
  std::string out;
  while (!text.empty()) {
    std::string_view from = text.substr(0, 1), to = from;
    for (const auto& [plain, spelled] : spellings) {
      if (text.starts_with(plain)) {
        from = plain;
        to = spelled;
      }
    }
    out += to;
    text.remove_prefix(from.size());
  }
  return out;
}

std::string latex_line(const std::vector<std::string>& cells) {
  std::string line = "  ";
  for (size_t i = 0; i < cells.size(); ++i) line.append(i > 0 ? " & " : "").append(escaped(cells[i]));
  return line + " \\\\\n";
}

}  // namespace

std::string to_latex(const Table& table) {
  std::string columns;
  std::vector<std::string> titles;
  for (const auto& [title, right] : table.columns) {
    columns += right ? 'r' : 'l';
    titles.push_back(title);
  }
  std::string text = "\\begin{table}\n";
  if (!table.caption.empty()) text += fmt::format("\\caption{{{}}}\n", escaped(table.caption));
  text += fmt::format("\\begin{{tabular}}{{{}}}\n\\toprule\n", columns);
  text += latex_line(titles);
  text += "\\midrule\n";
  for (const auto& row : table.rows) text += latex_line(row);
  return text + "\\bottomrule\n\\end{tabular}\n\\end{table}\n";
}

}  // namespace raysweep
