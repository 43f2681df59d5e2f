#include "results/rounds.h"

#include <fmt/format.h>

#include <set>

#include "results/factors.h"

namespace raysweep {

namespace {

/// Factors that the serial scheduler has no use for.
const std::set<std::string> only_of_threads{"runtime", "pin", "wait_policy", "spin_count", "environment"};

/// Schemas 1 and 2 name the default where schedulers that have no use for a factor have "-" today.
std::string usual_text(const FactorText& factor, const Record& r) {
  static const std::set<std::string> of_runtimes{"wait_policy", "spin_count", "environment"};
  std::string text = factor.text(r);
  const bool is_usual = of_runtimes.contains(factor.name) && (text.empty() || text == "default");
  return is_usual ? "-" : text;
}

/// What sets a cell apart from those that it is compared with.
struct Variant {
  std::string scheduler, chunk;
  int threads, processes, twin;
  double slowdown;
};

Variant own_variant(const Record& r) {
  return {r.scheduler, r.chunk, r.threads, r.processes, r.twin, r.slowdown};
}

/// All other factors are those of `r`.
std::string key_of(const Record& r, const Variant& v) {
  std::string key = fmt::format("{}{}", v.processes, v.twin > 0 ? fmt::format(" twin {}", v.twin) : "");
  const bool serial = v.scheduler == "serial";
  for (const FactorText& factor : factor_texts()) {
    key += "|" + (factor.name == "scheduler"                             ? v.scheduler
                  : factor.name == "threads"                             ? std::to_string(v.threads)
                  : factor.name == "chunk"                               ? v.chunk
                  : factor.name == "slowdown"                            ? fmt::format("{}", v.slowdown)
                  : serial && factor.name == "order" && r.order == "lpt" ? "scanline"
                  : serial && only_of_threads.contains(factor.name)      ? "-"
                                                                         : usual_text(factor, r));
  }
  return key;
}

}  // namespace

std::string own_key(const Record& r) { return key_of(r, own_variant(r)); }

std::string twin_key(const Record& r, int twin) {
  Variant variant = own_variant(r);
  variant.twin = twin;
  return key_of(r, variant);
}

std::string original_key(const Record& r) {
  Variant variant = own_variant(r);
  variant.twin = 0;
  variant.slowdown = 0;
  return key_of(r, variant);
}

std::string one_thread_key(const Record& r) { return key_of(r, {r.scheduler, r.chunk, 1, 1, 0, 0}); }

std::string serial_key(const Record& r, int processes) {
  return key_of(r, {"serial", "-", 1, processes, 0, 0});
}

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
