#include <fmt/core.h>

#include <cstdio>

#include "experiments/errors.h"
#include "experiments/verbs.h"
#include "results/record.h"
#include "schedulers/registry.h"
#include "tracer/scene/scenes.h"

namespace raysweep {

namespace {

int refuse(const char* sentence) {
  fmt::print(stderr, "raysweep: {}\n", sentence);
  return exit_refused;
}

int run_command(int argc, char** argv) {
  CommandLine line;
  try {
    add_all_verbs(line);
    refuse_unknown_verb(line, argc, argv);
    if (const auto code = line.app.parse(argc, argv)) return *code;
    return line.action();
  } catch (const RequestError& error) {
    return refuse(error.what());
  } catch (const SceneError& error) {
    return refuse(error.what());
  } catch (const SchedulerError& error) {
    return refuse(error.what());
  } catch (const RecordError& error) {
    return refuse(error.what());
  } catch (const std::bad_alloc&) {
    fmt::print(stderr, "raysweep: out of memory: choose a smaller picture, mesh or leaf count\n");
    return exit_failed;
  } catch (const std::exception& error) {
    fmt::print(stderr, "raysweep: {}\n", error.what());
    return exit_failed;
  }
}

}  // namespace

}  // namespace raysweep

int main(int argc, char** argv) { return raysweep::run_command(argc, argv); }
