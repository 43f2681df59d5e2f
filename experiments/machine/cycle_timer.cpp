#include "experiments/machine/cycle_timer.h"

#include <chrono>
#include <limits>
#include <nlohmann/json.hpp>
#include <vector>

#if defined(__x86_64__) || defined(__i386__)
#include <cpuid.h>
#include <x86intrin.h>
#define RAYSWEEP_X86
#endif

namespace raysweep {

namespace {

uint64_t steady_nanoseconds() {
  const auto now = std::chrono::steady_clock::now().time_since_epoch();
  return static_cast<uint64_t>(std::chrono::duration_cast<std::chrono::nanoseconds>(now).count());
}

constexpr TickSource steady_source{steady_nanoseconds, steady_nanoseconds};

#ifdef RAYSWEEP_X86

// The processor may read the counter before earlier instructions are done, or start later ones before it is
// read. M11's listing (Morozov 2011, after Paoloni 2010, "How to Benchmark Code Execution Times on Intel
// IA-32 and IA-64 Instruction Set Architectures") fences with cpuid, which takes 100 to 200 cycles and leaves
// to the hypervisor of a virtual machine, for thousands. Since then lfence is documented to wait for all
// earlier instructions and to hold back all later ones (Intel SDM volume 2, LFENCE; AMD since Zen under
// Linux), in tens of cycles.

uint64_t tsc_begin() {
  _mm_lfence();  // what came before does not run into the measured part
  const uint64_t ticks = __rdtsc();
  _mm_lfence();  // the measured part does not start before the reading
  return ticks;
}

uint64_t tsc_end() {
  unsigned processor = 0;
  const uint64_t ticks = __rdtscp(&processor);  // waits for all earlier instructions by itself
  _mm_lfence();                                 // what follows does not run into the measured part
  return ticks;
}

constexpr TickSource tsc_source{tsc_begin, tsc_end};

#else

constexpr TickSource tsc_source = steady_source;  // never chosen: `why_no_tsc`

#endif

/// Both clocks at one moment. Of a few tries the one whose two readings of the steady clock lie closest: in
/// that one, nothing came between.
struct Moment {
  uint64_t ticks, nanoseconds;
};

Moment read_both(const TickSource& source, uint64_t (*nanoseconds)()) {
  constexpr int tries = 5;
  uint64_t least = std::numeric_limits<uint64_t>::max();
  Moment moment{};
  for (int i = 0; i < tries; ++i) {
    const uint64_t before = nanoseconds();
    const uint64_t ticks = source.end();
    const uint64_t apart = nanoseconds() - before;
    if (apart >= least) continue;
    least = apart;
    moment = {ticks, before + apart / 2};
  }
  return moment;
}

TickClock calibrated_clock() {
  TickClock clock;
  clock.why = why_no_tsc(detect_tsc());
  clock.name = clock.why.empty() ? "tsc" : "steady_clock";
  clock.source = clock.why.empty() ? tsc_source : steady_source;
  const TickRate rate = clock.why.empty() ? measure_rate(clock.source, steady_nanoseconds) : TickRate{1e9, 0};
  clock.ticks_per_second = rate.ticks_per_second;
  clock.calibration_error = rate.error;
  clock.overhead_ticks = measure_overhead(clock.source);
  clock.resolution_ticks = measure_resolution(clock.source);
  clock.steady_resolution_seconds = static_cast<double>(measure_resolution(steady_source)) * 1e-9;
  return clock;
}

}  // namespace

TscSupport detect_tsc() {
  TscSupport support;
#ifdef RAYSWEEP_X86
  support.x86 = true;
  unsigned a = 0, b = 0, c = 0, d = 0;
  // Bits: Intel SDM volume 2, CPUID; AMD APM volume 3, appendix E.
  if (__get_cpuid(0x80000001U, &a, &b, &c, &d) != 0) support.rdtscp = (d >> 27U & 1U) != 0;
  if (__get_cpuid(0x80000007U, &a, &b, &c, &d) != 0) support.invariant = (d >> 8U & 1U) != 0;
#endif
  return support;
}

std::string why_no_tsc(const TscSupport& support) {
  if (!support.x86) return "the processor is not x86";
  if (!support.rdtscp) return "the processor has no rdtscp";
  if (!support.invariant) return "the time-stamp counter is not invariant: its rate may change";
  return {};
}

TickRate measure_rate(const TickSource& source, uint64_t (*nanoseconds)()) {
  constexpr int windows = 10;
  constexpr uint64_t window_nanoseconds = 4'000'000;  // readings are tens of ns apart: 10⁻⁵ of a window
  std::vector<double> rates;
  for (int i = 0; i < windows; ++i) {
    const Moment begin = read_both(source, nanoseconds);
    const uint64_t until = nanoseconds() + window_nanoseconds;
    while (nanoseconds() < until) {
    }
    const Moment end = read_both(source, nanoseconds);
    // Whole numbers first: a double holds 40 days of ticks, and machines are up for longer.
    rates.push_back(static_cast<double>(static_cast<int64_t>(end.ticks - begin.ticks)) * 1e9 /
                    static_cast<double>(end.nanoseconds - begin.nanoseconds));
  }
  std::sort(rates.begin(), rates.end());
  const double middle = (rates[windows / 2 - 1] + rates[windows / 2]) / 2;
  if (!(middle > 0)) return {0, 0};
  return {middle, (rates[windows - 1 - windows / 4] - rates[windows / 4]) / 2 / middle};
}

uint64_t measure_overhead(const TickSource& source) {
  constexpr int pairs = 1000;
  uint64_t least = std::numeric_limits<uint64_t>::max();
  for (int i = 0; i < pairs; ++i) {
    const uint64_t begin = source.begin(), end = source.end();
    if (end >= begin) least = std::min(least, end - begin);
  }
  return least == std::numeric_limits<uint64_t>::max() ? 0 : least;
}

uint64_t measure_resolution(const TickSource& source) {
  constexpr int readings = 1000;
  uint64_t least = 0;
  for (uint64_t i = 0, before = source.end(); i < readings; ++i) {
    const uint64_t now = source.end();
    if (now > before && (least == 0 || now - before < least)) least = now - before;
    before = now;
  }
  return least;
}

const TickClock& tick_clock() {
  static const TickClock clock = calibrated_clock();
  return clock;
}

double CycleTimer::ticks(Mode mode) const {
  switch (mode) {
    case Mode::sum:
      return static_cast<double>(sum_);
    case Mode::min:
      return static_cast<double>(min_);
    case Mode::max:
      return static_cast<double>(max_);
    case Mode::avg:
      return count_ == 0 ? 0 : static_cast<double>(sum_) / static_cast<double>(count_);
  }
  return 0;
}

TimerReport timer_report(const TickClock& clock) {
  return {clock.name,
          clock.why,
          clock.ticks_per_second,
          clock.calibration_error,
          clock.seconds(static_cast<double>(clock.overhead_ticks)),
          clock.seconds(static_cast<double>(clock.resolution_ticks)),
          clock.steady_resolution_seconds};
}

nlohmann::json to_json(const TimerReport& r) {
  return {{"source", r.source},
          {"why", r.why},
          {"ticks_per_second", r.ticks_per_second},
          {"calibration_error", r.calibration_error},
          {"overhead_seconds", r.overhead_seconds},
          {"resolution_seconds", r.resolution_seconds},
          {"steady_resolution_seconds", r.steady_resolution_seconds}};
}

}  // namespace raysweep
