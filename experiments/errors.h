// What a request can be told.
#pragma once

#include <stdexcept>

namespace raysweep {

/// The request was wrong, and nothing was run: exit code 2. The text is one sentence or more, each with
/// where, what, and what is possible.
struct RequestError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The work itself failed: exit code 1.
struct WorkError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

inline constexpr int exit_done = 0, exit_failed = 1, exit_refused = 2, exit_interrupted = 130;

}  // namespace raysweep
