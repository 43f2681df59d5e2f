// How a scheduler is made.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace raysweep {

/// Bounds of `threads`, both included. More threads than processors is oversubscription, and allowed.
inline constexpr int min_threads = 1, max_threads = 1024;

/// What a worker does while there is nothing to do: the runtime's own way, or to spin for long, or to sleep
/// at once. As OMP_WAIT_POLICY.
enum class WaitPolicy { usual, active, passive };

struct SchedulerOptions {
  int threads = 1;
  std::vector<int> processors{};        // worker w is bound to processors[w % size]; empty: not bound
  std::string runtime{};                // of a family that has several; empty: the first that is there
  WaitPolicy wait = WaitPolicy::usual;  // OpenMP and std::thread; TBB has no such choice
  std::optional<int> spin_count{};  // how often a waiting worker looks before it sleeps: libgomp, std::thread
};

}  // namespace raysweep
