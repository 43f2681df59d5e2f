#include "experiments/advise/advice_report.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "results/tables/number_text.h"

namespace raysweep {

namespace {

std::string share(double error) { return std::isinf(error) ? "none" : fmt::format("{:.1e}", error); }

std::string times_text(const std::vector<double>& nanoseconds) {
  return with_interval(estimate_median(nanoseconds));
}

std::string verdict(const Advice& advice, size_t index) {
  const auto& [predicted, measured, nanoseconds] = advice.all[index];
  if (advice.ranking.choice == index) return "chosen";
  if (advice.ranking.runner_up == index) return "next";
  if (advice.all[index].keeps(advice.tolerance)) return "keeps it";
  if (measured.error <= advice.tolerance) return "kept it here, which is not certain elsewhere";
  return std::isinf(predicted.bound) ? "can promise nothing" : "does not keep it";
}

void add_times(nlohmann::json& json, const char* name, const std::vector<double>& nanoseconds) {
  const Estimate estimate = estimate_median(nanoseconds);
  json[name] = estimate.value;
  json["low"] = estimate.interval ? nlohmann::json(estimate.interval->low) : nlohmann::json(nullptr);
  json["high"] = estimate.interval ? nlohmann::json(estimate.interval->high) : nlohmann::json(nullptr);
  json["rounds"] = nanoseconds.size();
}

nlohmann::json error_json(double bound) {
  return std::isinf(bound) ? nlohmann::json(nullptr) : nlohmann::json(bound);
}

nlohmann::json json_of(const MethodChoice& choice, double bound, const Measurement& measured) {
  return {
      {"method", choice.method},    {"precision", choice.precision},       {"predicted", error_json(bound)},
      {"measured", measured.error}, {"shown", error_json(measured.shown)}, {"missed", measured.missed}};
}

nlohmann::json json_of(const std::optional<size_t>& index, const std::vector<Advised>& all) {
  if (!index) return nullptr;
  const MethodChoice& choice = all[*index].predicted.choice;
  return {{"method", choice.method}, {"precision", choice.precision}};
}

nlohmann::json most_slower_json(const Advice& advice) {
  const auto share = most_slower(advice.all, advice.ranking, advice.tolerance);
  return share ? nlohmann::json(*share) : nlohmann::json(nullptr);
}

nlohmann::json json_of(const Spread& spread) {
  return {{"median", spread.median}, {"bad_end", spread.bad_end}};
}

}  // namespace

Table advice_table(const Advice& advice) {
  Table table;
  table.caption = fmt::format(
      "{}: {} triangles, {:.4g} from corner to corner; hit tolerance {} of that, which is {:.2g}; core {}\n"
      "errors of hit points that all but one in a thousand keep, as a share of the scene's size: predicted "
      "from {} hits, measured on {} others, and at most (95 %) by these\n"
      "processor time of a ray in whole pictures by one thread: median over {} rounds and its 95 % interval",
      advice.scene, advice.triangles, advice.size, advice.tolerance, advice.tolerance * advice.size,
      advice.core, advice.predicted_hits, advice.measured_hits, advice.all.front().nanoseconds.size());
  table.columns = {{"method", false}, {"precision", false}, {"predicted"}, {"measured"},
                   {"at most"},       {"missed"},           {"ns a ray"},  {"verdict", false}};
  for (size_t i = 0; i < advice.all.size(); ++i) {
    const auto& [predicted, measured, nanoseconds] = advice.all[i];
    table.rows.push_back({std::string(predicted.choice.method), std::string(predicted.choice.precision),
                          share(predicted.bound), share(measured.error), share(measured.shown),
                          std::to_string(measured.missed), times_text(nanoseconds), verdict(advice, i)});
  }
  return table;
}

Table study_table(const Advice& advice) {
  Table table;
  table.caption =
      "All methods of the study on the same hits; a test alone, each ray with the triangle that it hits, "
      "constants computed ahead";
  table.columns = {{"method", false}, {"precision", false}, {"predicted"},
                   {"measured"},      {"missed"},           {"ns a test"}};
  for (const StudyLine& line : advice.study) {
    table.rows.push_back({std::string(line.choice.method), std::string(line.choice.precision),
                          share(line.bound), share(line.measured.error), std::to_string(line.measured.missed),
                          times_text(line.nanoseconds)});
  }
  return table;
}

Table numbers_table(const Advice& advice) {
  Table table;
  table.caption = "What errors grow with: of the hits half are better, and all but one in a thousand";
  table.columns = {{"of a hit", false}, {"half"}, {"999 of 1000"}};
  const auto add = [&](const char* name, const Spread& spread) {
    table.rows.push_back({name, fmt::format("{:.3g}", spread.median), fmt::format("{:.3g}", spread.bad_end)});
  };
  add("largest coordinate", advice.numbers.coordinate);
  add("distance", advice.numbers.distance);
  add("longest edge", advice.numbers.edge);
  add("altitude / longest edge", advice.numbers.thinness);
  add("|cos| to the normal", advice.numbers.cosine);
  return table;
}

nlohmann::json to_json(const Advice& advice) {
  nlohmann::json rows = nlohmann::json::array(), study = nlohmann::json::array();
  for (size_t i = 0; i < advice.all.size(); ++i) {
    const auto& [predicted, measured, nanoseconds] = advice.all[i];
    nlohmann::json row = json_of(predicted.choice, predicted.bound, measured);
    row["promises"] = predicted.keeps(advice.tolerance);
    row["keeps"] = advice.all[i].keeps(advice.tolerance);
    row["verdict"] = verdict(advice, i);
    add_times(row, "ns_per_ray", nanoseconds);
    row["ns_per_ray_of_rounds"] = nanoseconds;
    rows.push_back(std::move(row));
  }
  for (const StudyLine& line : advice.study) {
    nlohmann::json row = json_of(line.choice, line.bound, line.measured);
    add_times(row, "ns_per_test", line.nanoseconds);
    study.push_back(std::move(row));
  }
  return {{"scene", advice.scene},
          {"triangles", advice.triangles},
          {"size", advice.size},
          {"hit_tolerance", advice.tolerance},
          {"core", advice.core},
          {"predicted_hits", advice.predicted_hits},
          {"measured_hits", advice.measured_hits},
          {"numbers",
           {{"coordinate", json_of(advice.numbers.coordinate)},
            {"distance", json_of(advice.numbers.distance)},
            {"edge", json_of(advice.numbers.edge)},
            {"thinness", json_of(advice.numbers.thinness)},
            {"cosine", json_of(advice.numbers.cosine)}}},
          {"rows", rows},
          {"choice", json_of(advice.ranking.choice, advice.all)},
          {"runner_up", json_of(advice.ranking.runner_up, advice.all)},
          {"most_slower", most_slower_json(advice)},
          {"advice", advice_text(advice.all, advice.ranking, advice.tolerance)},
          {"study", study}};
}

}  // namespace raysweep
