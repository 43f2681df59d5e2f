#include "experiments/overhead/idle_burn.h"

#include <chrono>
#include <ctime>
#include <thread>

#include "experiments/clock.h"

namespace raysweep {

namespace {

/// A sleep of 1 ms costs the sleeper itself 10 to 50 µs to go and come back; one spinning worker costs all of
/// it. In between lies a tenth.
constexpr double quiet_share = 0.1;

/// So long nothing may grow. A spinning worker may be off its processor for a time slice of another process,
/// a few milliseconds, and go on then.
constexpr double quiet_seconds = 0.02;

}  // namespace

IdleBurn watch_idle(const std::function<double()>& cpu_seconds, const std::function<double()>& sleep) {
  const double start = cpu_seconds();
  double last = start, quiet_from = start;  // processor time; the latter when the quiet began
  double passed = 0, quiet = 0;
  while (passed < idle_burn_cap_seconds) {
    const double slept = sleep(), now = cpu_seconds();
    passed += slept;
    if (now - last < quiet_share * slept) {
      quiet += slept;
    } else {
      quiet = 0;
      quiet_from = now;
    }
    if (quiet >= quiet_seconds) return {quiet_from - start, true};
    last = now;
  }
  return {last - start, false};
}

IdleBurn watch_idle() {
  const auto cpu_seconds = [] {
    timespec time{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
  };
  const auto sleep = [] {
    const double begin = now_seconds();
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    return now_seconds() - begin;
  };
  return watch_idle(cpu_seconds, sleep);
}

}  // namespace raysweep
