#include <fmt/core.h>
#include <poll.h>
#include <unistd.h>

#include <cstdio>
#include <nlohmann/json.hpp>

#include "experiments/errors.h"
#include "experiments/launch.h"
#include "experiments/runtime_variables.h"
#include "experiments/verbs.h"

namespace raysweep {

namespace {

void print_line(const std::string& line) {
  fmt::print("{}\n", line);
  std::fflush(stdout);
}

/// Whether standard input is still open: it closes with the parent.
bool parent_is_there() {
  pollfd input{STDIN_FILENO, POLLIN, 0};
  return poll(&input, 1, 0) == 0;
}

int run(const std::string& cell_text, LaunchOptions options, bool together) {
  const auto json = nlohmann::json::parse(cell_text, nullptr, false);
  Cell cell;
  try {
    cell = cell_from_json(json);
  } catch (const nlohmann::json::exception& error) {
    throw RequestError(fmt::format(
        "--cell must be a JSON object with every factor of a cell, as `raysweep run` passes it: {}",
        error.what()));
  }
  if (together) {
    options.before_timing = [] {
      print_line("ready");
      (void)std::getchar();  // "go", or the end of the parent
    };
    options.keep_busy = parent_is_there;
  }
  options.report = [](const Record& record) { print_line(to_line(record)); };
  forget_runtime_variables();
  run_launch(cell, options);
  return exit_done;
}

}  // namespace

void add_launch(CommandLine& line) {
  Command verb = add_verb(line, "launch", "one launch, in its own process: what `run` starts");
  static std::string cell;
  static LaunchOptions options;
  static bool picture = false, together = false;
  verb.add_option("--cell", cell, "the cell as JSON").required();
  verb.add_option("--seconds", options.seconds, "timed frames go on for so long").at_least_0();
  verb.add_flag("--picture", picture, "one untimed frame");
  verb.add_flag("--together", together,
                "print \"ready\" and wait for a line before timing; render on after it");
  verb.callback([&line] {
    line.action = [] {
      options.timed = !picture;
      return run(cell, options, together);
    };
  });
}

}  // namespace raysweep
