// What all programs of this folder do with their command line.
#pragma once

#include <fmt/format.h>

#include "experiments/command_line.h"
#include "experiments/errors.h"
#include "schedulers/registry.h"

namespace raysweep {

/// Parses, runs `action`, and tells what went wrong as a sentence. The exit code.
template <class Action>
int run_command(Command& app, int argc, char** argv, Action action) {
  const auto tell = [&](const std::exception& error, int code) {
    fmt::print(stderr, "{}: {}\n", app.name(), error.what());
    return code;
  };
  try {
    if (const auto code = app.parse(argc, argv)) return *code;
    return action();
  } catch (const RequestError& error) {
    return tell(error, exit_refused);
  } catch (const SchedulerError& error) {
    return tell(error, exit_refused);
  } catch (const std::exception& error) {
    return tell(error, exit_failed);
  }
}

}  // namespace raysweep
