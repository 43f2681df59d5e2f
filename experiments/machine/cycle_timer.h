// Times of a few nanoseconds: the processor's time-stamp counter where it can be trusted, with what reading
// it costs measured and taken off; else std::chrono. After M11 (Morozov 2011, 5.2), whose timer reads "cpuid;
// rdtsc … rdtscp; cpuid" and keeps a sum, the least, the most and the mean.
#pragma once

#include <algorithm>
#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>

namespace raysweep {

/// Where ticks come from. Functions, so that tests can have a clock of their own; the call is part of the
/// overhead that is measured and taken off.
struct TickSource {
  uint64_t (*begin)();  // nothing that follows has started yet
  uint64_t (*end)();    // all that came before is done
};

/// What the processor says of its counter.
struct TscSupport {
  bool x86 = false, rdtscp = false;
  bool invariant = false;  // same rate at every frequency and in every sleep (CPUID 0x80000007, EDX bit 8)
};

[[nodiscard]] TscSupport detect_tsc();

/// Why the counter cannot be used as a clock; empty if it can.
[[nodiscard]] std::string why_no_tsc(const TscSupport& support);

/// A source with its rate and its cost.
struct TickClock {
  TickSource source;
  std::string name;                      // "tsc" or "steady_clock"
  std::string why;                       // the reason why it is not the counter
  double ticks_per_second = 0;           // 0: it could not be calibrated
  double calibration_error = 0;          // relative: half of what the middle half of the windows spans
  uint64_t overhead_ticks = 0;           // the least of many empty pairs
  uint64_t resolution_ticks = 0;         // the least difference other than 0
  double steady_resolution_seconds = 0;  // of std::chrono::steady_clock

  [[nodiscard]] double seconds(double ticks) const {
    return ticks_per_second > 0 ? ticks / ticks_per_second : 0;
  }
};

struct TickRate {
  double ticks_per_second, error;
};

/// Ticks against a clock of nanoseconds, over windows of a few milliseconds, 40 ms together. The median, so
/// that windows in which the process was stopped between two readings do not count.
[[nodiscard]] TickRate measure_rate(const TickSource& source, uint64_t (*nanoseconds)());

/// The least of many empty pairs: what every measured time has in it at least, so that taking it off never
/// takes off too much.
[[nodiscard]] uint64_t measure_overhead(const TickSource& source);

/// The least difference other than 0 of readings one after the other; 0 if there was none.
[[nodiscard]] uint64_t measure_resolution(const TickSource& source);

/// The clock of this process, calibrated at the first call (50 ms).
[[nodiscard]] const TickClock& tick_clock();

/// Adds up what lies between begin and end, without the overhead. One thread at a time.
class CycleTimer {
 public:
  enum class Mode { sum, min, max, avg };

  CycleTimer(TickSource source, uint64_t overhead_ticks) : source_(source), overhead_(overhead_ticks) {}
  explicit CycleTimer(const TickClock& clock = tick_clock())
      : CycleTimer(clock.source, clock.overhead_ticks) {}

  void begin() { begin_ = source_.begin(); }
  void end() {
    const uint64_t now = source_.end();
    // Counters of two packages may differ a little: a thread that moved between them must not gain 2⁶⁴ ticks.
    add(now > begin_ ? now - begin_ : 0);
  }

  /// Ticks by this mode; 0 before the first end.
  [[nodiscard]] double ticks(Mode mode) const;
  [[nodiscard]] uint64_t count() const { return count_; }

 private:
  void add(uint64_t ticks) {
    ticks -= std::min(ticks, overhead_);
    sum_ += ticks;
    min_ = count_ == 0 ? ticks : std::min(min_, ticks);
    max_ = std::max(max_, ticks);
    count_++;
  }

  TickSource source_;
  uint64_t overhead_;
  uint64_t begin_ = 0, count_ = 0, sum_ = 0, min_ = 0, max_ = 0;
};

/// The clock as it is written down.
struct TimerReport {
  std::string source;  // "tsc" or "steady_clock"
  std::string why;     // reason of the fallback, or empty
  double ticks_per_second = 0;
  double calibration_error = 0;  // relative
  double overhead_seconds = 0;   // taken off every measured time
  double resolution_seconds = 0;
  double steady_resolution_seconds = 0;  // of std::chrono::steady_clock, which launches are timed by
};

[[nodiscard]] TimerReport timer_report(const TickClock& clock = tick_clock());
[[nodiscard]] nlohmann::json to_json(const TimerReport& report);

}  // namespace raysweep
