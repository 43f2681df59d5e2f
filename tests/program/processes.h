// Who started whom, and waiting for something to come true.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <thread>

namespace raysweep {

/// Parents of all processes, by process.
inline std::map<pid_t, pid_t> process_parents() {
  std::map<pid_t, pid_t> parents;
  for (const auto& entry : std::filesystem::directory_iterator("/proc")) {
    std::ifstream file(entry.path() / "stat");
    std::string text;
    if (!std::getline(file, text)) continue;
    std::istringstream rest(text.substr(text.rfind(')') + 1));  // the name before may hold anything
    char state = 0;
    pid_t parent = 0;
    if (rest >> state >> parent && state != 'Z') parents[std::atoi(text.c_str())] = parent;
  }
  return parents;
}

inline std::set<pid_t> children_of(pid_t pid) {
  std::set<pid_t> children;
  for (const auto& [child, parent] : process_parents()) {
    if (parent == pid) children.insert(child);
  }
  return children;
}

template <class Condition>
bool becomes_true(Condition&& condition) {
  const auto give_up = std::chrono::steady_clock::now() + std::chrono::seconds(60);
  while (!condition()) {
    if (std::chrono::steady_clock::now() > give_up) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return true;
}

}  // namespace raysweep
