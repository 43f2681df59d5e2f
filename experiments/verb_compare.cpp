#include <fmt/core.h>

#include <limits>
#include <nlohmann/json.hpp>
#include <optional>

#include "experiments/errors.h"
#include "experiments/numbers.h"
#include "experiments/picture_report.h"
#include "experiments/row_choice.h"
#include "experiments/verbs.h"
#include "results/run_comparison.h"
#include "tracer/difference_pictures.h"
#include "tracer/film_exr.h"

namespace raysweep {

namespace {

struct CompareOptions {
  std::vector<std::string> what, cells;
  std::string fail_if_slower, out;
};

/// "5%", "5 %" or "0.05" as a share; more than any slowdown where none is given.
double parse_share(const std::string& text) {
  if (text.empty()) return std::numeric_limits<double>::infinity();
  std::string number = text;
  const bool percent = number.ends_with('%');
  if (percent) number.pop_back();
  while (number.ends_with(' ')) number.pop_back();
  const auto value = parse_number<double>(number);
  const double share = value.value_or(-1) / (percent ? 100 : 1);
  if (!(share >= 0 && share < 1)) {
    throw RequestError(
        fmt::format("--fail-if-slower {}: a share from 0 to below 1 is possible, such as 5% or 0.05", text));
  }
  return share;
}

ExrPicture read_picture(const std::string& file) {
  try {
    return read_exr(file);
  } catch (const std::runtime_error& error) {
    throw RequestError(error.what());
  }
}

int compare_pictures(const CompareOptions& options, bool as_json) {
  if (!options.cells.empty() || !options.fail_if_slower.empty())
    throw RequestError("--cell and --fail-if-slower are for runs; these are pictures");
  if (!options.out.empty() && !options.out.ends_with(".png"))
    throw RequestError(
        fmt::format("--out {}: the map is written as .png; name a file that ends so", options.out));
  const ExrPicture a = read_picture(options.what[0]), b = read_picture(options.what[1]);
  std::optional<PictureDifference> difference;
  std::optional<FlipMap> map;
  try {
    difference = compare(b.film, b.hit_ids, a.film, a.hit_ids);
    map = flip(b.film, a.film);
    if (!options.out.empty()) write_png(picture_of(*map), options.out);
  } catch (const std::exception& error) {
    throw RequestError(error.what());
  }
  if (as_json) {
    nlohmann::json json = to_json(*difference);
    json["flip"] = to_json(*map);
    fmt::print("{}\n", json.dump(1));
  } else {
    const bool equal = a.film.hash() == b.film.hash();
    fmt::print("{} against {}: {}{}; {}\n", options.what[1], options.what[0],
               equal ? "equal in every bit; " : "", to_text(*difference), to_text(*map));
  }
  return exit_done;
}

RunComparison compare_what_was_asked(const CompareOptions& options) {
  if (options.cells.empty()) {
    if (options.what.size() != 2)
      throw RequestError("name two runs, or one and two of its cells by --cell FACTOR=VALUE,…, twice");
    return compare_runs(read_run(options.what[0]), read_run(options.what[1]));
  }
  if (options.what.size() != 1 || options.cells.size() != 2)
    throw RequestError("two cells of one run are compared: name one run, and --cell twice");
  const RunData run = read_run(options.what[0]);
  return compare_cells(run, choose_row(run.rows, options.cells[0]), choose_row(run.rows, options.cells[1]));
}

int run(const CompareOptions& options, bool as_json) {
  const auto is_picture = [](const std::string& file) { return file.ends_with(".exr"); };
  if (options.what.size() == 2 && is_picture(options.what[0]) && is_picture(options.what[1]))
    return compare_pictures(options, as_json);
  if (!options.out.empty()) throw RequestError("--out is for pictures; these are runs");
  const double share = parse_share(options.fail_if_slower);
  const RunComparison comparison = compare_what_was_asked(options);
  if (as_json) {
    fmt::print("{}\n", comparison_as_json(comparison).dump(1));
  } else {
    fmt::print("{}", to_text(comparison_table(comparison)));
  }
  if (options.fail_if_slower.empty()) return exit_done;
  if (const std::string unanswered = comparison.unanswered(); !unanswered.empty()) {
    fmt::print(stderr, "raysweep: --fail-if-slower cannot be answered: {}\n", unanswered);
    return exit_failed;
  }
  return comparison.slower_than(share) ? exit_failed : exit_done;
}

}  // namespace

void add_compare(CommandLine& line) {
  Command verb = add_verb(
      line, "compare", "two runs, or two cells of one, with intervals and a plain verdict; or two pictures");
  static CompareOptions options;
  verb.add_option("what", options.what,
                  "two folders of runs, A and B; one and --cell twice; or two .exr files")
      .required()
      .expected(1, 2);
  verb.add_option("--cell", options.cells, "FACTOR=VALUE,…: a cell of the run; the second against the first")
      .repeated();
  verb.add_option(
      "--fail-if-slower", options.fail_if_slower,
      "exit code 1 if a cell of B is shown to be slower, by more than this at best guess, such as "
      "5%; or if a cell of A cannot be compared");
  verb.add_option("--out", options.out, "of two pictures: where they differ to the eye (FLIP), as .png");
  verb.callback([&line] { line.action = [&line] { return run(options, line.json); }; });
}

}  // namespace raysweep
