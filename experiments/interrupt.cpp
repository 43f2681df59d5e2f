#include "experiments/interrupt.h"

#include <atomic>
#include <csignal>
#include <initializer_list>

namespace raysweep {

namespace {

/// Read by any thread; written by a handler, which may do so because no lock is behind it.
std::atomic<bool> caught = false;
static_assert(std::atomic<bool>::is_always_lock_free);

}  // namespace

void catch_interrupts() {
  struct sigaction action {};
  action.sa_handler = [](int) { caught = true; };
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction old {};
    sigaction(signal, nullptr, &old);
    if (old.sa_handler == SIG_IGN) continue;  // started by nohup, say: it stays ignored
    sigaction(signal, &action, nullptr);      // no SA_RESTART: waits wake up
  }
  // A limit on file sizes is told by the write that does not fit, which we answer for, and not by our death.
  std::signal(SIGXFSZ, SIG_IGN);
}

bool interrupted() { return caught; }

}  // namespace raysweep
