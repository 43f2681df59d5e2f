// The verbs of the command line. Each adds itself to the parser and, when chosen, sets `action`, which
// returns the exit code.
#pragma once

#include <functional>
#include <string>

#include "experiments/command_line.h"

namespace raysweep {

struct CommandLine {
  Command app{"raysweep: how fast does this picture get when more threads share it?", "raysweep"};
  bool json = false;  // one JSON document on standard output and nothing else there
  std::function<int()> action;
};

void add_run(CommandLine& line);
void add_render(CommandLine& line);
void add_list(CommandLine& line);
void add_topology(CommandLine& line);
void add_doctor(CommandLine& line);
void add_launch(CommandLine& line);
void add_report(CommandLine& line);
void add_compare(CommandLine& line);
void add_peers(CommandLine& line);
void add_advise(CommandLine& line);

/// All of them, and the options of the program itself.
void add_all_verbs(CommandLine& line);

/// Throws RequestError for a first argument that is no verb; the parser would only say that a verb is
/// missing.
void refuse_unknown_verb(const CommandLine& line, int argc, char** argv);

/// A verb with the options that all verbs have.
Command add_verb(CommandLine& line, const std::string& name, const std::string& summary);

}  // namespace raysweep
