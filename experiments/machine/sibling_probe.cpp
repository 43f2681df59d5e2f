#include "experiments/machine/sibling_probe.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>
#include <map>
#include <thread>

#include "experiments/clock.h"
#include "results/statistics/statistics.h"
#include "schedulers/binding.h"
#include "schedulers/registry.h"

namespace raysweep {

namespace {

// Hardware threads of a core each get half of its one multiplier; those of different cores disturb each other
// by the clock frequency alone, some tenths at most.
constexpr double of_one_core = 1.5;

/// Seconds for a fixed amount of multiplications, many at a time: unlike a chain of dependent ones, which
/// leaves the multiplier idle two cycles of three and lets a second thread have them.
double multiply() {
  constexpr int steps = 800'000;  // 2 ms: long beside the moment in which both begin
  std::array<uint64_t, 8> x{1, 2, 3, 4, 5, 6, 7, 8};
  const double begin = now_seconds();
  for (int i = 0; i < steps; ++i) {
    for (uint64_t& value : x) {
      value *= 6364136223846793005U;
      asm volatile("" : "+r"(value));  // says that it may have changed: no two steps become one
    }
  }
  return now_seconds() - begin;
}

/// The median of a few tries on all `processors` at once, by the slowest of them.
double seconds_together(const std::vector<int>& processors) {
  constexpr size_t tries = 5;
  std::vector<std::array<double, tries>> seconds(processors.size());
  std::vector<char> bound(processors.size());
  // They meet spinning: one that sleeps begins later than the other, whose work is then half done.
  std::atomic<size_t> arrivals{0};
  {
    std::vector<std::jthread> threads;
    for (size_t i = 0; i < processors.size(); ++i) {
      threads.emplace_back([&, i] {
        bound[i] = bind_this_thread({processors[i]});
        for (size_t t = 0; t < tries; ++t) {
          // Relaxed is enough: nothing but the moment is passed on.
          arrivals.fetch_add(1, std::memory_order_relaxed);
          while (arrivals.load(std::memory_order_relaxed) < (t + 1) * processors.size())
            std::this_thread::yield();
          seconds[i][t] = multiply();
        }
      });
    }
  }
  for (size_t i = 0; i < processors.size(); ++i) {
    if (!bound[i]) throw SchedulerError(fmt::format("no thread can be bound to processor {}", processors[i]));
  }
  std::vector<double> slowest(tries);
  for (size_t t = 0; t < tries; ++t) {
    for (const auto& own : seconds) slowest[t] = std::max(slowest[t], own[t]);
  }
  return median(std::move(slowest));
}

}  // namespace

std::vector<PairSlowdown> probe_siblings(const std::vector<int>& processors) {
  std::map<int, double> alone;
  for (const int p : processors) alone[p] = seconds_together({p});
  std::vector<PairSlowdown> pairs;
  for (size_t i = 0; i < processors.size(); ++i) {
    for (size_t j = i + 1; j < processors.size(); ++j) {
      const int a = processors[i], b = processors[j];
      pairs.push_back({a, b, seconds_together({a, b}) / std::max(alone[a], alone[b])});
    }
  }
  return pairs;
}

std::vector<std::string> disagreements(const std::vector<PairSlowdown>& pairs, const Topology& topology) {
  std::vector<std::string> sentences;
  for (const PairSlowdown& pair : pairs) {
    const HardwareThread* const a = topology.find(pair.first);
    const HardwareThread* const b = topology.find(pair.second);
    const bool said = a && b && a->core == b->core, seen = pair.slowdown >= of_one_core;
    if (said == seen) continue;
    sentences.push_back(
        fmt::format("processors {} and {} {} a core, says the topology; together each takes {:.2f} times as "
                    "long as alone: {}",
                    pair.first, pair.second, said ? "share" : "do not share", pair.slowdown,
                    seen ? "they share one, or the host runs them on one" : "they do not share one"));
  }
  return sentences;
}

}  // namespace raysweep
