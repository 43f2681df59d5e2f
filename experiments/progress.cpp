#include "experiments/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace raysweep {

namespace {

constexpr int bar_width = 24;
constexpr double line_interval_seconds = 15;  // between lines where there is no terminal

std::string as_clock(double seconds) {
  if (seconds < 0) return "–:––";
  const auto whole = static_cast<long>(std::ceil(seconds));
  return fmt::format("{}:{:02}", whole / 60, whole % 60);
}

}  // namespace

double seconds_left(int done, int total, double elapsed, double budget) {
  if (done == 0) return -1;
  const double by_pace = elapsed / done * (total - done);
  return std::max(0.0, std::min(by_pace, budget - elapsed));
}

Progress::Progress(std::string unit, double start_seconds, double budget_seconds, bool quiet)
    : unit_(std::move(unit)),
      start_(start_seconds),
      budget_(budget_seconds),
      last_(start_seconds),
      quiet_(quiet),
      terminal_(isatty(STDERR_FILENO) == 1) {}

Progress::~Progress() {
  if (terminal_ && !quiet_) fmt::print(stderr, "\r\033[K");
}

void Progress::show(int done, int total, double now, const std::string& label, const std::string& quality) {
  if (quiet_ || (!terminal_ && now - last_ < line_interval_seconds)) return;
  last_ = now;
  const std::string left = as_clock(seconds_left(done, total, now - start_, budget_));
  if (!terminal_) {
    fmt::print(stderr, "{} of {} {}, {} left{}{}\n", done, total, unit_, left, quality.empty() ? "" : ", ",
               quality);
    return;
  }
  const int filled = total > 0 ? static_cast<int>(static_cast<long long>(bar_width) * done / total) : 0;
  std::string bar;
  for (int i = 0; i < bar_width; ++i) bar += i < filled ? "█" : "░";
  fmt::print(stderr, "\r\033[K{} {}/{}  {} left  {}{}{}", bar, done, total, left, label,
             quality.empty() ? "" : "  ", quality);
  std::fflush(stderr);
}

std::string rough_duration(double seconds) {
  return seconds < 90 ? fmt::format("{:.0f} s", seconds) : fmt::format("{:.1f} min", seconds / 60);
}

}  // namespace raysweep
