#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "results/factors.h"
#include "results/run_comparison.h"
#include "results/tables/comparison_text.h"
#include "results/tables/number_text.h"

namespace raysweep {

namespace {

std::string verdict_text(const CellComparison& row, const NoiseFloor& floor) {
  return row.not_compared.empty() ? in_words(row.change, floor) : row.not_compared;
}

}  // namespace

Table comparison_table(const RunComparison& comparison) {
  Table table;
  table.caption = comparison.sentence + "\n" + comparison.floor.to_text() +
                  "; brackets hold 95 % intervals, those of changes for all rows together";
  for (const std::string& warning : comparison.warnings) table.caption += "\n" + warning;
  table.columns = {{"cell", false}, {"fps of A"}, {"fps of B"}, {"B against A"}, {"verdict", false}};
  for (const CellComparison& row : comparison.rows) {
    table.rows.push_back({row.name, with_interval(row.fps_a), with_interval(row.fps_b),
                          row.change ? signed_amount(*row.change) : "–",
                          verdict_text(row, comparison.floor)});
  }
  return table;
}

Table comparison_data(const RunComparison& comparison) {
  Table table;
  for (const FactorText& f : factor_texts()) table.columns.push_back({f.name, f.number});
  for (const char* title : {"fps_a", "fps_a_low", "fps_a_high", "fps_b", "fps_b_low", "fps_b_high", "ratio",
                            "ratio_low", "ratio_high", "adjusted_p"})
    table.columns.push_back({title});
  for (const char* title : {"verdict", "not_compared"}) table.columns.push_back({title, false});
  for (const CellComparison& row : comparison.rows) {
    std::vector<std::string> cells;
    for (const FactorText& f : factor_texts()) cells.push_back(f.text(row.cell));
    std::optional<Estimate> ratio;
    if (row.change) ratio = Estimate{row.change->ratio, row.change->interval, row.change->count};
    for (const auto& e : {row.fps_a, row.fps_b, ratio}) {
      for (std::string& number : unrounded(e)) cells.push_back(std::move(number));
    }
    cells.push_back(unrounded(row.adjusted_p));
    cells.push_back(row.not_compared.empty() ? to_string(row.verdict) : "");
    cells.push_back(row.not_compared);
    table.rows.push_back(std::move(cells));
  }
  return table;
}

nlohmann::json comparison_as_json(const RunComparison& comparison) {
  nlohmann::json json{{"sentence", comparison.sentence}, {"warnings", comparison.warnings}};
  json["noise_floor"] =
      comparison.floor.log_ratio ? nlohmann::json(*comparison.floor.log_ratio) : nlohmann::json();
  json["rows"] = rows_as_json(comparison_data(comparison));
  return json;
}

}  // namespace raysweep
