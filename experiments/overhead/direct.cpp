#include "experiments/overhead/direct.h"

#include <fmt/format.h>

#include <algorithm>

#include "experiments/clock.h"
#include "experiments/overhead/busy_work.h"
#include "experiments/overhead/command.h"
#include "experiments/overhead/comparison.h"
#include "experiments/overhead/numbers_text.h"
#include "experiments/overhead/report.h"
#include "experiments/overhead/task_sweep.h"

namespace raysweep {

namespace {

/// Of one item, some 30 ns: a few times what the cheapest chunk costs, which stays visible, while the workers
/// do not fight for a shared counter all the time.
constexpr std::uint64_t item_iterations = 30;

struct DirectOptions {
  int threads = 0;     // 0: one a processor
  int rounds = 101;    // an interval of the median leaves out 40 at each end
  int items = 20'000;  // a millisecond: a hundred times what waking the workers takes, less than a time slice
  std::string out;
};

struct Compared {
  DirectLoop loop;
  Comparison result;
};

/// Time of a processor that an item takes, after a shorter run that wakes the workers.
double nanoseconds_of_an_item(const std::function<void(size_t items)>& run, size_t items,
                              double useful_at_once) {
  run(items / 10);
  const double begin = now_seconds();
  run(items);
  return (now_seconds() - begin) * 1e9 * useful_at_once / static_cast<double>(items);
}

Compared compare_loop(const DirectLoop& loop, const DirectProgram& program, const DirectOptions& options,
                      double useful_at_once) {
  SchedulerOptions scheduler_options;
  scheduler_options.threads = options.threads;
  scheduler_options.runtime = program.runtime;
  const auto scheduler = make_scheduler(loop.scheduler, scheduler_options);
  const Body body = busy_items(item_iterations);
  WorkerLog log(options.threads);
  const auto items = static_cast<size_t>(options.items);
  const auto direct = [&] {
    return nanoseconds_of_an_item([&](size_t n) { loop.run(n, body, item_iterations); }, items,
                                  useful_at_once);
  };
  const auto ours = [&] {
    return nanoseconds_of_an_item([&](size_t n) { scheduler->run({n}, {1}, body, log); }, items,
                                  useful_at_once);
  };
  return {loop, compare(take_turns(direct, ours, options.rounds))};
}

std::string with_interval(const Estimate& e, int decimals) {
  std::string text = fmt::format("{:.{}f}", e.value, decimals);
  if (e.interval)
    text += fmt::format(" [{:.{}f}, {:.{}f}]", e.interval->low, decimals, e.interval->high, decimals);
  return text;
}

Table table_of(const std::vector<Compared>& list) {
  Table table;
  table.columns = {{"loop by hand", false}, {"scheduler", false},    {"by hand, ns/item"},
                   {"ours, ns/item"},       {"difference, ns/item"}, {"ratio"},
                   {"claim", false}};
  for (const auto& [loop, result] : list) {
    table.rows.push_back({loop.text, loop.scheduler, with_interval(result.direct, 1),
                          with_interval(result.ours, 1), with_interval(result.difference, 2),
                          with_interval(result.ratio, 4), std::string(text(judge(result)))});
  }
  return table;
}

Table numbers_of(const std::vector<Compared>& list, const DirectOptions& options) {
  Table table;
  table.columns = {{"loop"}, {"scheduler"}, {"threads"}, {"rounds"}, {"items"}};
  for (const char* value : {"direct_ns", "ours_ns", "difference_ns", "ratio"}) add_columns(table, value);
  table.columns.push_back({"claim"});
  for (const auto& [loop, result] : list) {
    std::vector<std::string> cells{loop.text, loop.scheduler, std::to_string(options.threads),
                                   std::to_string(options.rounds), std::to_string(options.items)};
    for (const Estimate& e : {result.direct, result.ours, result.difference, result.ratio})
      add_cells(cells, e);
    cells.emplace_back(text(judge(result)));
    table.rows.push_back(std::move(cells));
  }
  return table;
}

std::string explanation(const DirectOptions& options, int processors) {
  return fmt::format(
      "{} threads{}, {} rounds, in each both ways, in turns; {} items a run, each its own chunk where chunks "
      "can be chosen, of {} iterations of busy work; 95 % intervals of medians, of differences and ratios "
      "within "
      "rounds, in time of a processor. The claim: our interface costs at most {:.0f} % or {:.0f} ns more.",
      options.threads, options.threads > processors ? " (oversubscribed)" : "", options.rounds, options.items,
      item_iterations, 100 * (claimed_ratio - 1), claimed_nanoseconds);
}

int compare_loops(const DirectProgram& program, DirectOptions options) {
  const Machine machine = detect_machine();
  const int processors = machine.topology.processors();
  if (options.threads == 0) options.threads = std::min(processors, max_threads);
  if (!options.out.empty()) make_report_folder(options.out);
  std::vector<Compared> list;
  for (const DirectLoop& loop : program.loops(options.threads))
    list.push_back(compare_loop(loop, program, options, std::min(options.threads, processors)));
  const Report report{
      program.name,
      "What our interface costs over " + program.name.substr(program.name.rfind('_') + 1) + " by hand",
      {{program.name, explanation(options, processors), table_of(list), numbers_of(list, options)}}};
  print_report(report, machine);
  if (!options.out.empty()) write_report(report, machine, options.out);
  return exit_done;
}

}  // namespace

int compare_directly(const DirectProgram& program, int argc, char** argv) {
  Command app{"A loop by hand against the same through raysweep's schedulers, in turns", program.name};
  DirectOptions options;
  app.add_option("--threads", options.threads, "default: one a processor").range(min_threads, max_threads);
  app.add_option("--rounds", options.rounds, "six are needed for an interval")
      .range(1, 100'000)
      .capture_default_str();
  app.add_option("--items", options.items, "in each run").range(100, max_chunk).capture_default_str();
  app.add_option("--out", options.out, "write tables into this folder, as Markdown and CSV");
  return run_command(app, argc, argv, [&] { return compare_loops(program, options); });
}

}  // namespace raysweep
