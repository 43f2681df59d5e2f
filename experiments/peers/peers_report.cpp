#include "experiments/peers/peers_report.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "results/tables/number_text.h"

namespace raysweep {

namespace {

constexpr double mega = 1e6, mebibyte = 1024.0 * 1024.0;

const char* name_of(RayKind kind) { return ray_kind_names[static_cast<size_t>(kind)]; }
const char* name_of(DuelClass duel_class) { return duel_class_names[static_cast<size_t>(duel_class)]; }

void add_ratio(nlohmann::json& json, const Estimate& ratio) {
  json["ratio"] = ratio.value;
  json["low"] = ratio.interval ? nlohmann::json(ratio.interval->low) : nlohmann::json(nullptr);
  json["high"] = ratio.interval ? nlohmann::json(ratio.interval->high) : nlohmann::json(nullptr);
}

nlohmann::json to_json(const PeersRow& row) {
  nlohmann::json json{{"scene", row.scene},
                      {"triangles", row.triangles},
                      {"kind", name_of(row.kind)},
                      {"class", name_of(row.duel_class)},
                      {"ours", row.ours},
                      {"ours_mrays", row.ours_per_second / mega},
                      {"embree", row.embree},
                      {"embree_mrays", row.embree_per_second / mega},
                      {"hits_differ", row.between.rays}};
  add_ratio(json, row.ratio);
  return json;
}

nlohmann::json to_json(const PictureRow& row) {
  nlohmann::json json{{"scene", row.scene},
                      {"triangles", row.triangles},
                      {"mode", row.mode},
                      {"width", row.width},
                      {"height", row.height},
                      {"threads", row.threads},
                      {"ours", row.ours},
                      {"ours_fps", row.ours_per_second},
                      {"embree", row.embree},
                      {"embree_fps", row.embree_per_second},
                      {"embree_share", row.embree_share},
                      {"pixels_differ", row.differences.pixels},
                      {"largest_difference", row.differences.largest}};
  add_ratio(json, row.ratio);
  return json;
}

/// Null where nobody counted.
nlohmann::json bytes_or_null(size_t bytes) {
  return bytes > 0 ? nlohmann::json(bytes) : nlohmann::json(nullptr);
}

nlohmann::json to_json(const PeersBuild& build) {
  nlohmann::json json{{"scene", build.scene},
                      {"triangles", build.triangles},
                      {"class", build.build_class},
                      {"threads", build.threads},
                      {"ours_seconds", build.ours.seconds},
                      {"embree_seconds", build.embree.seconds},
                      {"ours_bytes", bytes_or_null(build.ours.bytes)},
                      {"embree_bytes", bytes_or_null(build.embree.bytes)}};
  add_ratio(json, build.ratio);
  return json;
}

/// "12 (9)": of 12 rays that differ, 9 do so in the same place.
std::string in_words(const HitDifferences& d) {
  return d.same_place > 0 ? fmt::format("{} ({})", d.rays, d.same_place) : std::to_string(d.rays);
}

std::string in_mebibytes(size_t bytes) {
  return bytes > 0 ? significant(static_cast<double>(bytes) / mebibyte) : "–";
}

}  // namespace

nlohmann::json to_json(const PeersResult& result) {
  nlohmann::json json{{"rows", nlohmann::json::array()},
                      {"pictures", nlohmann::json::array()},
                      {"builds", nlohmann::json::array()}};
  for (const PeersRow& row : result.rows) json["rows"].push_back(to_json(row));
  for (const PictureRow& row : result.pictures) json["pictures"].push_back(to_json(row));
  for (const PeersBuild& build : result.builds) json["builds"].push_back(to_json(build));
  return json;
}

Table rays_table(const PeersResult& result, const PeersRequest& request, const EmbreeModule& embree) {
  Table table;
  table.caption = fmt::format(
      "peers: ours and Embree {}{} on the same rays, one thread; triangles alone, a ray a pixel of {} × {}; "
      "{} rounds in random order, medians; ratio: ours / Embree's by round [95 % interval]\n"
      "single: a ray at a time, medium quality; best: the fastest of all modes; robust: of those "
      "that promise to miss nothing at edges; hits that differ: between the two, ours from the oracle, "
      "Embree's from the oracle (in the same place)",
      embree.version, embree.has_assertions ? " (as packaged: with assertions)" : "", request.width,
      request.height, request.duel.rounds);
  table.columns = {{"scene", false}, {"kind", false}, {"rays"},          {"class", false},
                   {"ours", false},  {"Mrays/s"},     {"Embree", false}, {"Mrays/s"},
                   {"ratio"},        {"hits differ"}, {"ours off"},      {"Embree off"}};
  for (const PeersRow& row : result.rows) {
    table.rows.push_back({row.scene, name_of(row.kind), std::to_string(row.rays), name_of(row.duel_class),
                          row.ours, significant(row.ours_per_second / mega), row.embree,
                          significant(row.embree_per_second / mega), with_interval(row.ratio),
                          in_words(row.between), in_words(row.ours_from_oracle),
                          in_words(row.embree_from_oracle)});
  }
  return table;
}

Table pictures_table(const PeersResult& result, const PeersRequest& request, const EmbreeModule& embree) {
  Table table;
  table.caption = fmt::format(
      "Pictures: ours, and the same tracer with Embree {}{} as its core, planes and spheres included (each "
      "tested with every ray there); tiles "
      "of {} × {} "
      "by a counter; {} rounds in random order, medians; ratio: ours / Embree's by round [95 % interval]\n"
      "Embree: the fastest of its ways on a part of the picture; share: of its threads' time inside Embree's "
      "calls; "
      "pixels that differ between the two, and by how much of a linear channel at most",
      embree.version, embree.has_assertions ? " (as packaged: with assertions)" : "", picture_tile,
      picture_tile, request.pictures.rounds);
  table.columns = {{"scene", false}, {"mode", false}, {"size"},          {"threads"},
                   {"ours", false},  {"fps"},         {"Embree", false}, {"fps"},
                   {"ratio"},        {"share"},       {"pixels differ"}, {"at most"}};
  for (const PictureRow& row : result.pictures) {
    table.rows.push_back({row.scene, row.mode, fmt::format("{} × {}", row.width, row.height),
                          std::to_string(row.threads), row.ours, significant(row.ours_per_second), row.embree,
                          significant(row.embree_per_second), with_interval(row.ratio),
                          percent(row.embree_share), std::to_string(row.differences.pixels),
                          significant(row.differences.largest)});
  }
  return table;
}

Table builds_table(const PeersResult& result) {
  Table table;
  table.caption = fmt::format(
      "Builds: from triangles to what rays are traced in, medians of {} rounds; class: quality, and "
      "where it is high, triangles may be cut in two; ratio of times: ours / Embree's by round [95 % "
      "interval]",
      build_rounds);
  table.columns = {{"scene", false}, {"triangles"}, {"class", false}, {"threads"},    {"ours, ms"},
                   {"Embree, ms"},   {"ratio"},     {"ours, MiB"},    {"Embree, MiB"}};
  for (const PeersBuild& build : result.builds) {
    table.rows.push_back({build.scene, std::to_string(build.triangles), build.build_class,
                          std::to_string(build.threads), significant(build.ours.seconds * 1e3),
                          significant(build.embree.seconds * 1e3), with_interval(build.ratio),
                          in_mebibytes(build.ours.bytes), in_mebibytes(build.embree.bytes)});
  }
  return table;
}

}  // namespace raysweep
