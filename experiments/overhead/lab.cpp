#include "experiments/overhead/lab.h"

#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>

#include <cstdlib>
#include <exception>
#include <memory>

#include "experiments/child.h"
#include "experiments/errors.h"
#include "experiments/interrupt.h"
#include "experiments/overhead/busy_work.h"

namespace raysweep {

namespace {

std::vector<std::string> row_arguments(const Subject& subject, const std::string& parts,
                                       const WorkSpeed& speed, double seconds) {
  const Subject plain{{}, {}, 1, subject.wait, {}, false};
  std::vector<std::string> arguments{"row",
                                     "--scheduler",
                                     subject.scheduler,
                                     "--threads",
                                     std::to_string(subject.threads),
                                     "--wait-policy",
                                     plain.wait_text(),
                                     "--measure",
                                     parts,
                                     "--seconds",
                                     fmt::format("{}", seconds),
                                     "--call-ns",
                                     fmt::format("{}", speed.call),
                                     "--iteration-ns",
                                     fmt::format("{}", speed.iteration)};
  const auto add = [&](const char* option, const std::string& value) {
    arguments.emplace_back(option);
    arguments.push_back(value);
  };
  if (!subject.runtime.empty()) add("--runtime", subject.runtime);
  if (subject.spin_count) add("--spin-count", std::to_string(*subject.spin_count));
  return arguments;
}

}  // namespace

std::vector<OverheadRow> measure_rows(const std::vector<Subject>& subjects, const std::string& parts,
                                      const MeasureRow& measure) {
  std::vector<OverheadRow> rows;
  for (const Subject& subject : subjects) {
    if (interrupted()) break;
    fmt::print(stderr, "{}/{} {}\n", rows.size() + 1, subjects.size(), subject.text());
    OverheadRow row{subject};
    row.before = measure_work_speed();
    try {
      row.samples = measure(subject, parts, row.before);
    } catch (const WorkError& error) {
      row.problem = error.what();
    }
    row.after = measure_work_speed();
    if (!interrupted()) rows.push_back(std::move(row));
  }
  return rows;
}

RowSamples measure_in_a_child(const Subject& subject, const std::string& parts, const WorkSpeed& speed,
                              double seconds) {
  std::unique_ptr<Child> load;
  if (subject.beside_load) {
    load = std::make_unique<Child>(std::vector<std::string>{"load"});
    (void)load->read_line();  // it is at work now
  }
  Child child(row_arguments(subject, parts, speed, seconds));
  const auto line = child.read_line();
  if (!line) throw WorkError(interrupted() ? "interrupted" : child.how_it_ended());
  try {
    return row_samples_from_line(*line);
  } catch (const std::exception& error) {
    throw WorkError(fmt::format("its samples cannot be read: {}", error.what()));
  }
}

void be_busy() {
  fmt::print("busy\n");
  std::fflush(stdout);
  pollfd input{STDIN_FILENO, POLLIN, 0};
  while (poll(&input, 1, 0) == 0) busy_work(1'000'000);  // a look at standard input each millisecond or two
}

void refuse_waiting_environment() {
  for (const char* variable : {"OMP_WAIT_POLICY", "GOMP_SPINCOUNT", "KMP_BLOCKTIME"}) {
    if (std::getenv(variable) != nullptr)
      throw RequestError(
          fmt::format("{} is set in the environment and would decide how workers wait in rows that say "
                      "otherwise; unset it, and use --wait-policy",
                      variable));
  }
}

}  // namespace raysweep
