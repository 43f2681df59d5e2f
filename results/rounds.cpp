#include "results/rounds.h"

#include <set>

#include "results/factors.h"

namespace raysweep {

namespace {

/// Factors that the serial scheduler has no use for.
const std::set<std::string> only_of_threads{"runtime", "pin", "wait_policy", "spin_count", "environment"};

}  // namespace

std::string base_key(const Record& r, const std::string& scheduler, int threads, const std::string& chunk,
                     int processes) {
  std::string key = std::to_string(processes);
  for (const FactorText& factor : factor_texts()) {
    key += "|" + (factor.name == "scheduler" ? scheduler
                  : factor.name == "threads" ? std::to_string(threads)
                  : factor.name == "chunk"   ? chunk
                  : scheduler == "serial" && factor.name == "order" && r.order == "lpt" ? "scanline"
                  : scheduler == "serial" && only_of_threads.contains(factor.name)      ? "-"
                                                                                        : factor.text(r));
  }
  return key;
}

std::string serial_key(const Record& r, int processes) { return base_key(r, "serial", 1, "-", processes); }

std::string own_key(const Record& r) { return base_key(r, r.scheduler, r.threads, r.chunk, r.processes); }

Launches::Launches(const std::vector<Record>& records) {
  // A launch that was void and tried again on resume has two records: the later one counts.
  std::map<std::pair<std::string, int>, const Record*> latest;
  for (const Record& r : records) latest[{r.cell, r.round}] = &r;
  for (const auto& [cell_and_round, r] : latest) {
    by_cell_[r->cell].push_back(r);
    if (r->valid) by_key_[own_key(*r)][r->round] = r;
  }
}

std::vector<const Record*> Launches::of_cell(const std::string& cell) const {
  const auto found = by_cell_.find(cell);
  return found == by_cell_.end() ? std::vector<const Record*>() : found->second;
}

const Rounds& Launches::valid(const std::string& key) const {
  static const Rounds none;
  const auto found = by_key_.find(key);
  return found == by_key_.end() ? none : found->second;
}

}  // namespace raysweep
