// What does an OpenMP region cost after the team size changed? Empty regions of one size against regions of
// two sizes in turns. A program of its own, since changed teams leave their mark on a process.
#include <fmt/format.h>
#include <omp.h>

#include "experiments/clock.h"
#include "experiments/overhead/command.h"
#include "experiments/overhead/numbers_text.h"
#include "experiments/overhead/report.h"
#include "results/statistics/statistics.h"

namespace raysweep {

namespace {

struct TeamOptions {
  int rounds = 51;    // an interval of the median leaves out 18 at each end
  int regions = 200;  // of each size in a round: 50 µs each at worst, so ten milliseconds
  std::string out;
};

struct Sizes {
  int small, large;
};

/// Nanoseconds of a region, each round's mean.
struct Changed {
  Sizes sizes;
  Estimate small, large;  // one after another of the same size
  Estimate alternating;
  Estimate change;  // alternating − mean of both, within rounds
};

void empty_region(int threads) {
#pragma omp parallel num_threads(threads)
  asm volatile("");  // a region that is empty for the compiler may be none
}

/// The mean over `count` pairs of regions.
double nanoseconds_of_a_region(int first, int second, int count) {
  empty_region(first);  // the change to this size is not timed
  empty_region(second);
  const double begin = now_seconds();
  for (int i = 0; i < count; ++i) {
    empty_region(first);
    empty_region(second);
  }
  return (now_seconds() - begin) * 1e9 / (2.0 * count);
}

Changed measure(const Sizes& sizes, const TeamOptions& options) {
  std::vector<double> small, large, alternating, change;
  for (int round = 0; round < options.rounds; ++round) {
    small.push_back(nanoseconds_of_a_region(sizes.small, sizes.small, options.regions));
    alternating.push_back(nanoseconds_of_a_region(sizes.small, sizes.large, options.regions));
    large.push_back(nanoseconds_of_a_region(sizes.large, sizes.large, options.regions));
    change.push_back(alternating.back() - (small.back() + large.back()) / 2);
  }
  return {sizes, estimate_median(small), estimate_median(large), estimate_median(alternating),
          estimate_median(change)};
}

Table table_of(const std::vector<Changed>& list, int processors) {
  Table table;
  table.columns = {{"sizes"},    {"smaller alone"},  {"larger alone"},
                   {"in turns"}, {"a change costs"}, {"notes", false}};
  for (const Changed& c : list) {
    table.rows.push_back({fmt::format("{}, {}", c.sizes.small, c.sizes.large), duration_text(c.small),
                          duration_text(c.large), duration_text(c.alternating), duration_text(c.change),
                          c.sizes.large > processors ? "oversubscribed"
                          : c.sizes.small == 1       ? "a region of one thread needs no team"
                                                     : ""});
  }
  return table;
}

Table numbers_of(const std::vector<Changed>& list) {
  Table table;
  table.columns = {{"small"}, {"large"}};
  for (const char* value : {"small_ns", "large_ns", "alternating_ns", "change_ns"}) add_columns(table, value);
  for (const Changed& c : list) {
    std::vector<std::string> cells{std::to_string(c.sizes.small), std::to_string(c.sizes.large)};
    for (const Estimate& e : {c.small, c.large, c.alternating, c.change}) add_cells(cells, e);
    table.rows.push_back(std::move(cells));
  }
  return table;
}

int run(const TeamOptions& options) {
  const Machine machine = detect_machine();
  const int processors = machine.topology.processors();
  if (!options.out.empty()) make_report_folder(options.out);
  omp_set_dynamic(0);
  std::vector<Changed> list;
  // Halves and doubles of the processors' count; a team of one is no team.
  if (processors >= 2) list.push_back(measure({processors / 2, processors}, options));
  list.push_back(measure({processors, 2 * processors}, options));
  const Report report{"overhead_team_sizes",
                      "What changing the size of an OpenMP team costs",
                      {{"overhead_team_sizes",
                        "Empty regions by the compiler's own OpenMP: of one size one after another, and of "
                        "two sizes in turns; "
                        "`a change costs`: what a region in turns takes longer than the mean of both alone. "
                        "95 % intervals of "
                        "medians over rounds.",
                        table_of(list, processors), numbers_of(list)}}};
  print_report(report, machine);
  if (!options.out.empty()) write_report(report, machine, options.out);
  return exit_done;
}

int measure_teams(int argc, char** argv) {
  Command app{"What does changing the size of an OpenMP team cost?", "overhead_team_sizes"};
  TeamOptions options;
  app.add_option("--rounds", options.rounds, "six are needed for an interval")
      .range(1, 100'000)
      .capture_default_str();
  app.add_option("--regions", options.regions, "pairs of regions of each kind in a round")
      .range(1, 1'000'000)
      .capture_default_str();
  app.add_option("--out", options.out, "write tables into this folder, as Markdown and CSV");
  return run_command(app, argc, argv, [&] { return run(options); });
}

}  // namespace

}  // namespace raysweep

int main(int argc, char** argv) { return raysweep::measure_teams(argc, argv); }
