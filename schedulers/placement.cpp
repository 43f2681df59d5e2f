#include "schedulers/placement.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <map>
#include <tuple>

#include "schedulers/options.h"

namespace raysweep {

namespace {

using Threads = std::vector<HardwareThread>;
constexpr size_t max_list = 4096;

constexpr std::array policies{
    PinPolicy{"none", "the operating system places threads as it likes, and moves them"},
    PinPolicy{"cores", "one thread on each physical core, fastest first; then their second hardware threads"},
    PinPolicy{"compact", "all hardware threads of a core before the next core, fastest first"},
    PinPolicy{"scatter", "as cores, but spread over packages, and over caches within them"},
    PinPolicy{"one_core", "all threads on one core, on its hardware threads: hyper-threading alone"},
    PinPolicy{"LIST", "processors by number, for one thread after the other: 0,2,4-7"},
};

template <class Key>
Threads sorted(Threads threads, Key key) {
  std::ranges::stable_sort(threads, {}, key);
  return threads;
}

Threads by_cores(const Topology& topology) {
  return sorted(topology.hardware_threads,
                [](const HardwareThread& t) { return std::tuple(t.sibling, -t.speed, t.core); });
}

Threads compact(const Topology& topology) {
  return sorted(topology.hardware_threads,
                [](const HardwareThread& t) { return std::tuple(-t.speed, t.core, t.sibling); });
}

/// Dealt round robin over the groups that `group` puts them in; in each group the order stays.
template <class Group>
Threads dealt(const Threads& threads, Group group) {
  std::map<int, int> seen;
  std::vector<std::pair<int, HardwareThread>> turns;
  for (const HardwareThread& t : threads) turns.emplace_back(seen[group(t)]++, t);
  std::ranges::stable_sort(turns, {}, [](const auto& turn) { return turn.first; });
  Threads result;
  for (const auto& turn : turns) result.push_back(turn.second);
  return result;
}

Threads scatter(const Topology& topology) {
  const Threads spread = dealt(dealt(by_cores(topology), [](const HardwareThread& t) { return t.cache; }),
                               [](const HardwareThread& t) { return t.package; });
  return sorted(spread, [](const HardwareThread& t) { return t.sibling; });
}

/// The first of the cores with the most hardware threads.
Threads one_core(const Topology& topology) {
  std::map<int, Threads> cores;
  for (const HardwareThread& t : compact(topology)) cores[t.core].push_back(t);
  const auto largest = std::ranges::max_element(
      cores, {}, [](const auto& core) { return std::pair(core.second.size(), core.second.front().speed); });
  return largest == cores.end() ? Threads() : largest->second;
}

std::optional<int> parse_processor(std::string_view text) {
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool whole = error == std::errc() && end == text.data() + text.size() && !text.empty();
  return whole && value >= 0 ? std::optional(value) : std::nullopt;
}

/// "0,2,4-7" as numbers; none for anything else.
std::optional<std::vector<int>> parse_list(std::string_view text) {
  std::vector<int> list;
  for (size_t at = 0; at <= text.size();) {
    const size_t comma = std::min(text.find(',', at), text.size());
    const std::string_view part = text.substr(at, comma - at);
    const size_t dash = part.find('-');
    const auto first = parse_processor(part.substr(0, dash));
    const auto last = dash == std::string_view::npos ? first : parse_processor(part.substr(dash + 1));
    if (!first || !last || *last < *first || static_cast<size_t>(*last - *first) >= max_list)
      return std::nullopt;
    for (int p = *first; p <= *last; ++p) list.push_back(p);
    at = comma + 1;
  }
  return list.size() <= max_list ? std::optional(list) : std::nullopt;
}

std::vector<int> numbers(const Threads& threads) {
  std::vector<int> list;
  for (const HardwareThread& t : threads) list.push_back(t.processor);
  return list;
}

/// The processors of a policy in the order in which threads get them.
std::vector<int> order_of(const std::string& pin, const Topology& topology) {
  if (pin == "none") return {};
  if (pin == "cores") return numbers(by_cores(topology));
  if (pin == "compact") return numbers(compact(topology));
  if (pin == "scatter") return numbers(scatter(topology));
  if (pin == "one_core") return numbers(one_core(topology));
  return parse_list(pin).value_or(std::vector<int>());
}

}  // namespace

std::span<const PinPolicy> pin_policies() { return policies; }

std::string processor_list(const std::vector<int>& processors) {
  std::string text;
  for (size_t i = 0; i < processors.size();) {
    size_t last = i;
    while (last + 1 < processors.size() && processors[last + 1] == processors[last] + 1) last++;
    text += fmt::format("{}{}", text.empty() ? "" : ",", processors[i]);
    if (last > i) text += fmt::format("-{}", processors[last]);
    i = last + 1;
  }
  return text;
}

std::string pin_problem(const std::string& pin, const std::vector<int>& allowed) {
  const bool named = std::ranges::any_of(policies, [&](const PinPolicy& p) { return p.name == pin; });
  if (named && pin != "LIST") return {};
  const auto list = parse_list(pin);
  if (!list) {
    return fmt::format(
        "unknown pin \"{}\"; possible: none, cores, compact, scatter, one_core, or a list of processors such "
        "as 0,2,4-7",
        pin);
  }
  for (const int p : *list) {
    if (!allowed.empty() && std::ranges::find(allowed, p) == allowed.end()) {
      return fmt::format("pin = {}: processor {} is not allowed here; allowed: {}", pin, p,
                         processor_list(allowed));
    }
  }
  return {};
}

std::vector<int> place(const std::string& pin, int threads, const Topology& topology) {
  const std::vector<int> order = order_of(pin, topology);
  std::vector<int> placed;
  for (int t = 0; t < threads && !order.empty(); ++t)
    placed.push_back(order[static_cast<size_t>(t) % order.size()]);
  return placed;
}

std::optional<HyperThreadingPlacements> hyper_threading_placements(const Topology& topology) {
  std::map<std::pair<int, int>, std::vector<int>> cores;  // by speed, fastest first, and core
  for (const HardwareThread& t : topology.hardware_threads) cores[{-t.speed, t.core}].push_back(t.processor);
  std::erase_if(cores, [](const auto& core) { return core.second.size() < 2; });
  if (cores.empty()) return std::nullopt;
  const int fastest = cores.begin()->first.first;
  std::erase_if(cores, [&](const auto& core) { return core.first.first != fastest; });
  while (cores.size() > max_threads / 2 || (cores.size() > 1 && cores.size() % 2 == 1))
    cores.erase(std::prev(cores.end()));
  HyperThreadingPlacements placements{static_cast<int>(cores.size()), {}, {}, {}};
  for (const auto& [core, processors] : cores) {
    const bool in_first_half = placements.one_each.size() < cores.size() / 2;
    placements.one_each.push_back(processors[0]);
    for (const int sibling : {0, 1}) {
      placements.two_each.push_back(processors[static_cast<size_t>(sibling)]);
      if (in_first_half) placements.packed.push_back(processors[static_cast<size_t>(sibling)]);
    }
  }
  return placements;
}

}  // namespace raysweep
