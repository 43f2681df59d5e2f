#include "results/report_data.h"

#include <nlohmann/json.hpp>

#include "results/claims/claim_text.h"

namespace raysweep {

namespace {

using nlohmann::json;

json or_null(const std::optional<double>& value) { return value ? json(*value) : json(); }

json or_null(const std::string& text) { return text.empty() ? json() : json(text); }

void add_interval(json& to, const std::optional<Estimate::Bounds>& interval) {
  to["low"] = interval ? json(interval->low) : json();
  to["high"] = interval ? json(interval->high) : json();
}

json estimate_as_json(const Estimate& estimate) {
  json made{{"value", estimate.value}, {"count", estimate.count}};
  add_interval(made, estimate.interval);
  return made;
}

json or_null(const std::optional<Estimate>& estimate) {
  return estimate ? estimate_as_json(*estimate) : json();
}

json row_as_json(const MeasuredCell& cell) {
  json row{{"cell", cell.cell},         {"factors", cell.factors}, {"values", json::object()},
           {"samples", json::object()}, {"notes", cell.notes},     {"oversubscribed", cell.oversubscribed}};
  for (const auto& [quantity, value] : cell.values) {
    if (value.value.count == 0) continue;
    row["values"][quantity] = estimate_as_json(value.value);
    // What was timed; the others follow from it.
    if (quantity != "fps" && quantity != "nanoseconds") continue;
    for (const auto& [round, sample] : value.by_round) row["samples"][quantity].push_back({round, sample});
  }
  return row;
}

json group_as_json(const GroupJudgement& group) {
  json made{{"group", group.group},
            {"value", or_null(group.value)},
            {"expected_low", or_null(group.low)},
            {"expected_high", or_null(group.high)},
            {"holds", group.holds ? json(*group.holds) : json()},
            {"problem", or_null(group.problem)}};
  add_interval(made, group.interval);
  return made;
}

json side_as_json(const SideJudgement& side, const std::string& verdict) {
  json made{{"verdict", verdict}, {"sentence", side.sentence}, {"groups", json::array()}};
  for (const GroupJudgement& group : side.groups) made["groups"].push_back(group_as_json(group));
  return made;
}

json published_as_json(const PublishedTable& table, const std::vector<PublishedRow>& rows) {
  json made{{"file", table.file},
            {"quantity", table.quantity},
            {"normalise", table.normalise},
            {"rows_are", table.rows},
            {"machine", {{"cores", table.machine.cores}, {"pus", table.machine.pus}}},
            {"rows", json::array()}};
  for (const PublishedRow& row : rows) {
    made["rows"].push_back({{"factors", row.factors},
                            {"printed", row.printed},
                            {"printed_normalised", or_null(row.printed_normalised)},
                            {"ours", or_null(row.ours)},
                            {"ours_normalised", or_null(row.ours_normalised)}});
  }
  return made;
}

json table_as_json(const NamedTable& named) {
  const Table& table = named.table;
  json made{{"name", named.name},
            {"title", table.caption.substr(0, table.caption.find('\n'))},
            {"caption", table.caption},
            {"columns", json::array()},
            {"rows", table.rows}};
  for (const Table::Column& column : table.columns)
    made["columns"].push_back({{"title", column.title}, {"number", column.right}});
  return made;
}

}  // namespace

json claims_as_json(const std::vector<ClaimJudgement>& claims) {
  json list = json::array();
  for (const ClaimJudgement& one : claims) {
    list.push_back({{"id", one.claim.id},
                    {"text", one.claim.text},
                    {"source", one.claim.source},
                    {"rule", rule_sentence(one.claim)},
                    {"published", side_as_json(one.published, one.published_verdict())},
                    {"ours", side_as_json(one.ours, one.our_verdict())},
                    {"why", or_null(one.claim.why)}});
  }
  return list;
}

json report_as_json(const JudgedRun& report, const std::vector<NamedTable>& tables) {
  const RunMachine& machine = report.machine;
  const ClaimSheet& sheet = report.sheet;
  json made{{"schema", report_schema},
            {"experiment", report.experiment},
            {"title", report.title},
            {"question", sheet.question},
            {"kind", report.kind},
            // Of runs of older programs, which did not keep it: by the config that lies beside.
            {"command", sheet.command.empty() ? "raysweep run config.toml" : sheet.command},
            {"machine",
             {{"host", machine.host},
              {"cpu", machine.cpu},
              {"cores", machine.counts.cores},
              {"pus", machine.counts.pus}}},
            {"noise_floor", or_null(report.noise_floor)},
            {"rows", json::array()},
            {"claims", claims_as_json(report.claims)},
            {"published", sheet.published ? published_as_json(*sheet.published, report.published) : json()},
            {"tables", json::array()}};
  for (const MeasuredCell& cell : report.cells) made["rows"].push_back(row_as_json(cell));
  for (const NamedTable& table : tables) made["tables"].push_back(table_as_json(table));
  return made;
}

}  // namespace raysweep
