// What does it cost to hand work out? Per scheduler, runtime and threads: an empty region, a chunk, and the
// smallest task that keeps an efficiency; and what workers do while they wait.
#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "experiments/interrupt.h"
#include "experiments/numbers.h"
#include "experiments/overhead/command.h"
#include "experiments/overhead/lab.h"
#include "experiments/overhead/report.h"
#include "experiments/overhead/row.h"

namespace raysweep {

namespace {

struct LabOptions {
  std::vector<std::string> schedulers;
  std::string threads = "1,cores,processors", wait_policy = "default", study = "all", out;
  double seconds = 5;
  bool beside_load = false;
};

struct RowOptions {
  std::string scheduler, runtime, wait_policy = "default", parts = "region,chunks,sizes";
  int threads = 1;
  std::optional<int> spin_count;
  double seconds = 5;
  WorkSpeed speed{};
};

/// CLI11's own range up to the largest number is told with all its 309 digits.
std::string problem_of_seconds(const std::string& text) {
  const auto seconds = parse_number<double>(text);
  return seconds && *seconds > 0 && *seconds <= 3600 ? "" : text + " is no number above 0 and up to 3600";
}

RowParts parse_parts(const std::string& list) {
  RowParts parts;
  std::istringstream in(list);
  for (std::string word; std::getline(in, word, ',');) {
    bool* const part = word == "region"   ? &parts.region
                       : word == "chunks" ? &parts.chunks
                       : word == "sizes"  ? &parts.sizes
                       : word == "burn"   ? &parts.burn
                                          : nullptr;
    if (!part)
      throw RequestError(fmt::format(
          "--measure: \"{}\" is unknown; possible: region, chunks, sizes, burn, by commas", word));
    *part = true;
  }
  return parts;
}

int run_row(const RowOptions& options, const std::vector<std::string>& benchmark_flags) {
  const Subject subject{options.scheduler,  options.runtime,
                        options.threads,    parse_wait_policy(options.wait_policy),
                        options.spin_count, false};
  const int processors = static_cast<int>(allowed_processors().size());
  const RowRequest request{subject, parse_parts(options.parts), options.seconds,
                           static_cast<double>(std::min(options.threads, processors)), options.speed};
  fmt::print("{}\n", to_line(measure_row(request, benchmark_flags)));
  return exit_done;
}

const char* const schedulers_explanation =
    "Each row is a process of its own; brackets hold 95 % intervals of the median over repetitions. `empty "
    "region`: a run with one item of nothing for each thread. `per chunk`: what a run of `chunks/run` chunks "
    "of nothing takes longer, in time of a processor, for each chunk. `METG`: the smallest task, one a "
    "chunk, "
    "with which useful time is still that share of all processors' time, 1000 tasks a thread; interpolated "
    "between two measured sizes, else `not bracketed`. A task's length is that of busy work on one thread "
    "alone, "
    "before and after the row; `drift` is what changed between. Schedulers that ignore chunks hand out "
    "blocks.";

const char* const waiting_explanation =
    "How idle workers wait. `empty region` as above; `slowest repetition`: the slowest of the repetitions, "
    "each a mean over many regions; `idle burn`: processor time that the process uses after a region until "
    "it "
    "goes quiet, watched for up to a second. Less than a tenth of a processor for 20 ms counts as quiet.";

int run_lab(const LabOptions& options) {
  const Machine machine = detect_machine();
  const int processors = machine.topology.processors();
  const auto threads = parse_threads(options.threads, machine.topology.cores(), processors);
  const WaitPolicy wait = parse_wait_policy(options.wait_policy);
  const auto subjects = scheduler_subjects(options.schedulers, threads, wait);
  refuse_waiting_environment();
  if (!options.out.empty()) make_report_folder(options.out);
  catch_interrupts();
  const MeasureRow measure = [&](const Subject& subject, const std::string& parts, const WorkSpeed& speed) {
    return measure_in_a_child(subject, parts, speed, options.seconds);
  };
  Report report{options.study == "waiting" ? "waiting" : "overhead", "What handing work out costs", {}};
  std::vector<OverheadRow> all;
  if (options.study != "waiting") {
    all = measure_rows(subjects, "region,chunks,sizes", measure);
    const std::string explanation =
        fmt::format("{} Wait policy: {}.", schedulers_explanation, options.wait_policy);
    report.parts.push_back(
        {"overhead", explanation, scheduler_table(all, processors), scheduler_numbers(all, processors)});
    report.parts.push_back({"task_sizes", "", {}, task_size_numbers(all, processors)});
  }
  if (options.study != "schedulers") {
    const auto rows = measure_rows(waiting_subjects(threads, options.beside_load), "region,burn", measure);
    report.parts.push_back(
        {"waiting", waiting_explanation, waiting_table(rows, processors), waiting_numbers(rows, processors)});
    all.insert(all.end(), rows.begin(), rows.end());
  }
  print_report(report, machine);
  if (interrupted()) return exit_interrupted;
  if (!options.out.empty()) write_report(report, machine, options.out);
  const auto failed = [](const OverheadRow& row) { return !row.problem.empty(); };
  return std::ranges::any_of(all, failed) ? exit_failed : exit_done;
}

void add_lab_options(Command& app, LabOptions& options) {
  app.add_option("--scheduler", options.schedulers, "these (default: all that are available)");
  app.add_option("--threads", options.threads, "counts, \"cores\" and \"processors\", by commas")
      .capture_default_str();
  app.add_option("--wait-policy", options.wait_policy, "of idle workers: default, active or passive")
      .capture_default_str();
  app.add_option("--study", options.study, "schedulers, waiting (how workers wait) or all")
      .one_of({"schedulers", "waiting", "all"})
      .capture_default_str();
  app.add_flag("--beside-load", options.beside_load,
               "measure each way to wait again beside one busy process on the same processors");
  app.add_option("--seconds", options.seconds, "about so long a row")
      .check(problem_of_seconds, "POSITIVE")
      .capture_default_str();
  app.add_option("--out", options.out, "write tables into this folder, as Markdown and CSV");
}

Command add_row(Command& app, RowOptions& options) {
  Command row = app.add_subcommand("row",
                                   "one row in this process: what this program starts itself; "
                                   "takes Google Benchmark's flags, --benchmark_…");
  row.allow_extras();
  row.add_option("--scheduler", options.scheduler).required();
  row.add_option("--runtime", options.runtime, "of OpenMP: libgomp or libomp");
  row.add_option("--threads", options.threads).range(min_threads, max_threads);
  row.add_option("--wait-policy", options.wait_policy);
  row.add_option("--spin-count", options.spin_count).at_least_0();
  row.add_option("--measure", options.parts, "region, chunks, sizes, burn, by commas").capture_default_str();
  row.add_option("--seconds", options.seconds).check(problem_of_seconds, "POSITIVE");
  row.add_option("--call-ns", options.speed.call, "of busy work of no iterations").at_least_0();
  row.add_option("--iteration-ns", options.speed.iteration, "of busy work; measured if it is not given")
      .check(problem_of_seconds, "POSITIVE");
  return row;
}

int start(int argc, char** argv) {
  Command app{"What does handing work out cost, per scheduler, runtime and threads?", "overhead_lab"};
  LabOptions lab;
  RowOptions row_options;
  add_lab_options(app, lab);
  const Command row = add_row(app, row_options);
  const Command load = app.add_subcommand("load", "use a processor until standard input is closed");
  app.require_subcommand(0, 1);
  return run_command(app, argc, argv, [&] {
    if (row.was_given()) return run_row(row_options, row.remaining());
    if (load.was_given()) return be_busy(), exit_done;
    return run_lab(lab);
  });
}

}  // namespace

}  // namespace raysweep

int main(int argc, char** argv) { return raysweep::start(argc, argv); }
