#include "results/tables/pixels_tables.h"

#include <fmt/format.h>

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

}  // namespace

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
  for (const char* title : {"scene",          "offset",         "mode",
                            "width",          "height",         "core",
                            "method",         "precision",      "pixels",
                            "wrong_pixels",   "hole_pixels",    "nonfinite_pixels",
                            "flip_mean",      "flip_p95",       "flip_max",
                            "max_difference", "rmse",           "rays",
                            "ns_per_ray",     "ns_per_ray_low", "ns_per_ray_high",
                            "void_rounds"})
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
                          text(row.void_rounds)});
  }
  return table;
}

std::string pixels_tables_as_text(const PixelsData& data) {
  std::string text =
      fmt::format("{}: {}\n\n{}", data.experiment, data.title, to_text(pixels_table(data.rows)));
  for (const std::string& one : data.left_out) text += fmt::format("left out: {}\n", one);
  return text;
}

std::vector<NamedTable> write_pixels_tables(const PixelsData& data, const std::filesystem::path& folder) {
  TableFolder files(folder);
  files.write("pixels", pixels_table(data.rows));
  write_file(folder / "cells.csv", to_csv(pixels_data(data.rows)));
  return files.tables();
}

}  // namespace raysweep
