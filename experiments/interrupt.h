// Ctrl-C and its kin, as a flag.
#pragma once

namespace raysweep {

/// From now on SIGINT, SIGTERM and SIGHUP set a flag instead of ending the process.
void catch_interrupts();

/// Whether one has come.
[[nodiscard]] bool interrupted();

}  // namespace raysweep
