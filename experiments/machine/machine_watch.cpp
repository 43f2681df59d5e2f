#include "experiments/machine/machine_watch.h"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <sstream>
#include <thread>

#include "experiments/clock.h"
#include "experiments/machine/kernel_files.h"

namespace raysweep {

namespace fs = std::filesystem;

namespace {

/// "1234 (a name (with) brackets) R …": utime and stime are the 14th and 15th field, the 12th and 13th after
/// the name (proc(5)). None for what is no such line.
std::optional<ProcessTime> parse_process(const std::string& line) {
  const size_t open = line.find('('), close = line.rfind(')');
  if (open == std::string::npos || close == std::string::npos || close < open) return std::nullopt;
  std::istringstream in(line.substr(close + 1));
  std::string skipped;
  for (int i = 0; i < 11; ++i) in >> skipped;
  double user = 0, system = 0;
  if (!(in >> user >> system)) return std::nullopt;
  return ProcessTime{line.substr(open + 1, close - open - 1),
                     (user + system) / static_cast<double>(sysconf(_SC_CLK_TCK))};
}

}  // namespace

std::map<int, ProcessTime> process_times(const fs::path& root) {
  std::map<int, ProcessTime> times;
  std::error_code error;
  for (fs::directory_iterator entry(root / "proc", error), end; !error && entry != end;
       entry.increment(error)) {
    const std::string name = entry->path().filename();
    if (name.find_first_not_of("0123456789") != std::string::npos) continue;
    // It may have ended since.
    const auto line = first_line(entry->path() / "stat");
    if (!line) continue;
    if (auto process = parse_process(*line)) times.emplace(std::atoi(name.c_str()), *std::move(process));
  }
  return times;
}

std::vector<BusyProcess> busiest_between(const std::map<int, ProcessTime>& before,
                                         const std::map<int, ProcessTime>& after, double seconds, int but) {
  constexpr size_t at_most = 5;
  constexpr double least = 0.01;
  std::vector<BusyProcess> busy;
  for (const auto& [id, now] : after) {
    const auto then = before.find(id);
    // One that was not there has used all its time since.
    const double used = now.seconds - (then == before.end() ? 0 : then->second.seconds);
    if (id != but && used >= least * seconds) busy.push_back({id, now.name, used / seconds});
  }
  std::sort(busy.begin(), busy.end(),
            [](const BusyProcess& a, const BusyProcess& b) { return a.processors > b.processors; });
  busy.resize(std::min(busy.size(), at_most));
  return busy;
}

MachineWatch watch_machine(double seconds, const fs::path& root) {
  constexpr double between_spins = 0.05;  // a spin takes 1 ms: 2 % of one processor
  MachineWatch watch;
  const auto processes = process_times(root);
  const StateCounters before = read_state(root);
  for (const double end = before.wall_seconds + seconds; now_seconds() < end;) {
    watch.spin_seconds.push_back(spin_seconds());
    const double pause = std::min(between_spins, end - now_seconds());
    if (pause > 0) std::this_thread::sleep_for(std::chrono::duration<double>(pause));
  }
  watch.change = change_between(before, read_state(root));
  watch.busiest =
      busiest_between(processes, process_times(root), watch.change.wall_seconds.value_or(seconds), getpid());
  return watch;
}

}  // namespace raysweep
