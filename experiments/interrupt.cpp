#include "experiments/interrupt.h"

#include <csignal>
#include <initializer_list>

namespace raysweep {

namespace {

volatile std::sig_atomic_t caught = 0;

}  // namespace

void catch_interrupts() {
  struct sigaction action {};
  action.sa_handler = [](int) { caught = 1; };
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction old {};
    sigaction(signal, nullptr, &old);
    if (old.sa_handler == SIG_IGN) continue;  // started by nohup, say: it stays ignored
    sigaction(signal, &action, nullptr);      // no SA_RESTART: waits wake up
  }
  // A limit on file sizes is told by the write that does not fit, which we answer for, and not by our death.
  std::signal(SIGXFSZ, SIG_IGN);
}

bool interrupted() { return caught != 0; }

}  // namespace raysweep
