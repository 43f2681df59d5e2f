#include <fmt/core.h>

#include <cstdio>

#include "experiments/errors.h"
#include "experiments/verbs.h"
#include "results/record.h"
#include "schedulers/registry.h"
#include "tracer/scene/scenes.h"

namespace raysweep {

CLI::App* add_verb(CommandLine& line, const std::string& name, const std::string& summary) {
  CLI::App* const verb = line.app.add_subcommand(name, summary);
  verb->add_flag("--json", line.json, "one JSON document on standard output, everything else on standard error");
  return verb;
}

namespace {

int refuse(const char* sentence) {
  fmt::print(stderr, "raysweep: {}\n", sentence);
  return exit_refused;
}

int run_command(int argc, char** argv) {
  CommandLine line;
  line.app.require_subcommand(1);
  line.app.set_version_flag("--version", RAYSWEEP_VERSION);
  for (const auto add : {add_run, add_render, add_list, add_topology, add_report, add_launch}) add(line);
  try {
    line.app.parse(argc, argv);
    return line.action();
  } catch (const CLI::ParseError& error) {
    return line.app.exit(error) == 0 ? exit_done : exit_refused;
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
