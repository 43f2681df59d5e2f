#include "experiments/overhead/subject.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <sstream>

#include "experiments/errors.h"
#include "experiments/numbers.h"
#include "schedulers/registry.h"

namespace raysweep {

namespace {

/// libgomp's spin count that the table of gotchas measured as the way out between spinning and sleeping.
constexpr int tried_spin_count = 10'000;

constexpr std::string_view wait_names[] = {"default", "active", "passive"};  // in the order of WaitPolicy

const SchedulerInfo& known_scheduler(const std::string& name) {
  if (const SchedulerInfo* info = find_scheduler(name)) return *info;
  std::vector<std::string_view> known;
  for (const SchedulerInfo& info : all_schedulers()) known.push_back(info.name);
  throw RequestError(
      fmt::format("--scheduler: unknown scheduler \"{}\"; possible: {}", name, fmt::join(known, ", ")));
}

/// The runtimes that it can run on here; one empty name where there is no choice.
std::vector<std::string> available_runtimes(const SchedulerInfo& info) {
  if (!info.uses_runtime())
    return why_unavailable(info).empty() ? std::vector<std::string>{""} : std::vector<std::string>{};
  std::vector<std::string> names;
  for (const RuntimeInfo& runtime : all_runtimes()) {
    const std::string name(runtime.name);
    if (runtime.family == info.family && why_unavailable(info, name).empty()) names.push_back(name);
  }
  return names;
}

int parse_thread_count(const std::string& word, int cores, int processors) {
  if (word == "cores") return std::min(cores, max_threads);
  if (word == "processors") return std::min(processors, max_threads);
  const auto number = parse_number<int>(word);
  if (number && *number >= min_threads && *number <= max_threads) return *number;
  throw RequestError(
      fmt::format("--threads: \"{}\" is no count of threads; possible: numbers from {} to {}, cores, "
                  "processors, by commas",
                  word, min_threads, max_threads));
}

}  // namespace

SchedulerOptions Subject::options() const {
  SchedulerOptions options;
  options.threads = threads;
  options.runtime = runtime;
  options.wait = wait;
  options.spin_count = spin_count;
  return options;
}

std::string Subject::wait_text() const {
  return spin_count ? fmt::format("spin {}", *spin_count)
                    : std::string(wait_names[static_cast<size_t>(wait)]);
}

std::string Subject::text() const {
  std::string text = scheduler + (runtime.empty() ? "" : ", " + runtime);
  text += fmt::format(", {} thread{}", threads, threads == 1 ? "" : "s");
  if (spin_count || wait != WaitPolicy::usual) text += ", " + wait_text();
  return beside_load ? text + ", beside a busy process" : text;
}

std::vector<int> parse_threads(const std::string& list, int cores, int processors) {
  std::set<int> counts;
  std::istringstream in(list + ",");  // so that an empty last word is seen too
  for (std::string word; std::getline(in, word, ',');)
    counts.insert(parse_thread_count(word, cores, processors));
  return {counts.begin(), counts.end()};
}

WaitPolicy parse_wait_policy(const std::string& name) {
  const auto* const found = std::ranges::find(wait_names, name);
  if (found == std::end(wait_names))
    throw RequestError(
        fmt::format("--wait-policy: \"{}\" is none; possible: {}", name, fmt::join(wait_names, ", ")));
  return static_cast<WaitPolicy>(found - std::begin(wait_names));
}

std::vector<Subject> scheduler_subjects(std::span<const std::string> names, std::span<const int> threads,
                                        WaitPolicy wait) {
  std::vector<std::string> wanted(names.begin(), names.end());
  if (wanted.empty()) {
    for (const SchedulerInfo& info : all_schedulers()) wanted.emplace_back(info.name);
  }
  std::vector<Subject> subjects;
  for (const std::string& name : wanted) {
    const SchedulerInfo& info = known_scheduler(name);
    const auto runtimes = available_runtimes(info);
    if (runtimes.empty() && !names.empty())
      throw RequestError(fmt::format("--scheduler: \"{}\" is {}", name, why_unavailable(info)));
    const WaitPolicy own_wait = info.uses_wait_policy() ? wait : WaitPolicy::usual;
    for (const std::string& runtime : runtimes) {
      for (const int count : threads) {
        if (info.uses_threads || count == threads.front())
          subjects.push_back({name, runtime, info.uses_threads ? count : 1, own_wait, {}, false});
      }
    }
  }
  return subjects;
}

std::vector<Subject> waiting_subjects(std::span<const int> threads, bool beside_load) {
  std::vector<Subject> subjects;
  for (const char* name : {"thread_static", "omp_static"}) {
    const SchedulerInfo& info = known_scheduler(name);
    for (const std::string& runtime : available_runtimes(info)) {
      for (const int count : threads) {
        if (count == 1) continue;  // nobody waits
        for (const bool load : beside_load ? std::vector{false, true} : std::vector{false}) {
          for (const auto wait : {WaitPolicy::usual, WaitPolicy::active, WaitPolicy::passive})
            subjects.push_back({name, runtime, count, wait, {}, load});
          if (uses_spin_count(info, runtime))
            subjects.push_back({name, runtime, count, WaitPolicy::usual, tried_spin_count, load});
        }
      }
    }
  }
  return subjects;
}

}  // namespace raysweep
