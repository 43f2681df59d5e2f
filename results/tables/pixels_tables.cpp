#include "results/tables/pixels_tables.h"

#include <fmt/format.h>

#include <utility>

#include "results/tables/number_text.h"
#include "results/tables/table_files.h"
#include "results/tables/write_file.h"

namespace raysweep {

namespace {

/// "studio", or "studio + 10000" where it was moved.
std::string scene_text(const PixelsRecord& r) {
  return r.offset == 0 ? r.scene : fmt::format("{} + {:g}", r.scene, r.offset);
}

/// "0", or three digits of what differs a little.
std::string flip_text(double value) { return fmt::format("{:.3g}", value); }

/// Without the picture itself, which all rows of a picture share.
std::string method_text(const PixelsRow& row) {
  return row.void_rounds == 0 ? row.first.method
                              : fmt::format("{} ({} rounds void)", row.first.method, row.void_rounds);
}

bool is_of_sampling(const PixelsRecord& r) { return r.subpixels != r.reference_subpixels; }

}  // namespace

Table sampling_table(const std::vector<PixelsRow>& rows) {
  Table table{
      "pictures of few samples against one of many: the root of the mean square of what linear channels "
      "differ by, "
      "everywhere and at its edges, what is seen of that (FLIP, 0 to 1), and what a ray takes on one thread",
      {{"scene", false},
       {"mode", false},
       {"core", false},
       {"method", false},
       {"precision", false},
       {"pattern", false},
       {"samples"},
       {"of reference"},
       {"RMSE"},
       {"edge pixels"},
       {"RMSE at edges"},
       {"FLIP mean"},
       {"FLIP p95"},
       {"ns/ray"}},
      {}};
  for (const PixelsRow& row : rows) {
    const PixelsRecord& r = row.first;
    if (!is_of_sampling(r)) continue;
    table.rows.push_back({scene_text(r), r.mode, r.core, method_text(row), r.precision, r.pattern,
                          std::to_string(r.subpixels), std::to_string(r.reference_subpixels),
                          flip_text(r.rmse), std::to_string(r.edge_pixels), flip_text(r.edge_rmse),
                          flip_text(r.flip_mean), flip_text(r.flip_p95),
                          with_interval(row.nanoseconds_per_ray)});
  }
  return table;
}

Table pixels_table(const std::vector<PixelsRow>& rows) {
  Table table{
      "pixels that differ from a watertight picture in doubles by more than 1 of 255, what is seen of that "
      "(FLIP, 0 to 1), and what a ray takes on one thread",
      {{"scene", false},
       {"mode", false},
       {"core", false},
       {"method", false},
       {"precision", false},
       {"pixels"},
       {"wrong"},
       {"holes"},
       {"not finite"},
       {"FLIP mean"},
       {"FLIP p95"},
       {"FLIP max"},
       {"max of 255"},
       {"ns/ray"}},
      {}};
  for (const PixelsRow& row : rows) {
    const PixelsRecord& r = row.first;
    if (is_of_sampling(r)) continue;
    table.rows.push_back({scene_text(r), r.mode, r.core, method_text(row), r.precision,
                          std::to_string(r.pixels), std::to_string(r.wrong_pixels),
                          std::to_string(r.hole_pixels), std::to_string(r.nonfinite_pixels),
                          flip_text(r.flip_mean), flip_text(r.flip_p95), flip_text(r.flip_max),
                          std::to_string(r.max_difference), with_interval(row.nanoseconds_per_ray)});
  }
  return table;
}

Table pixels_data(const std::vector<PixelsRow>& rows) {
  Table table;
  for (const char* title : {"scene",
                            "offset",
                            "mode",
                            "width",
                            "height",
                            "core",
                            "method",
                            "precision",
                            "pixels",
                            "wrong_pixels",
                            "hole_pixels",
                            "nonfinite_pixels",
                            "flip_mean",
                            "flip_p95",
                            "flip_max",
                            "max_difference",
                            "rmse",
                            "rays",
                            "ns_per_ray",
                            "ns_per_ray_low",
                            "ns_per_ray_high",
                            "void_rounds",
                            "pattern",
                            "subpixels",
                            "reference_subpixels",
                            "edge_pixels",
                            "edge_rmse"})
    table.columns.push_back({title});
  const auto text = [](const auto& value) { return fmt::format("{}", value); };
  for (const PixelsRow& row : rows) {
    const PixelsRecord& r = row.first;
    const auto [value, low, high] = unrounded(row.nanoseconds_per_ray);
    table.rows.push_back({r.scene,
                          text(r.offset),
                          r.mode,
                          text(r.width),
                          text(r.height),
                          r.core,
                          r.method,
                          r.precision,
                          text(r.pixels),
                          text(r.wrong_pixels),
                          text(r.hole_pixels),
                          text(r.nonfinite_pixels),
                          text(r.flip_mean),
                          text(r.flip_p95),
                          text(r.flip_max),
                          text(r.max_difference),
                          text(r.rmse),
                          text(r.rays),
                          value,
                          low,
                          high,
                          text(row.void_rounds),
                          r.pattern,
                          text(r.subpixels),
                          text(r.reference_subpixels),
                          text(r.edge_pixels),
                          text(r.edge_rmse)});
  }
  return table;
}

namespace {

/// Those that have rows.
std::vector<std::pair<std::string, Table>> named_tables(const std::vector<PixelsRow>& rows) {
  std::vector<std::pair<std::string, Table>> tables{{"pixels", pixels_table(rows)},
                                                    {"sampling", sampling_table(rows)}};
  std::erase_if(tables, [](const auto& one) { return one.second.rows.empty(); });
  return tables;
}

}  // namespace

std::string pixels_tables_as_text(const PixelsData& data) {
  std::string text = fmt::format("{}: {}\n", data.experiment, data.title);
  for (const auto& [name, table] : named_tables(data.rows)) text.append("\n").append(to_text(table));
  for (const std::string& one : data.left_out) text += fmt::format("left out: {}\n", one);
  return text;
}

std::vector<NamedTable> write_pixels_tables(const PixelsData& data, const std::filesystem::path& folder) {
  TableFolder files(folder);
  for (const auto& [name, table] : named_tables(data.rows)) files.write(name, table);
  write_file(folder / "cells.csv", to_csv(pixels_data(data.rows)));
  return files.tables();
}

}  // namespace raysweep
