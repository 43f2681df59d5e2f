// What does each method of intersection promise, and what is it expected to fail? Prints the contract as
// scripts/record_contract keeps it.
#include <fmt/format.h>

#include "experiments/intersection/accuracy.h"
#include "results/contract.h"

namespace raysweep {

namespace {

/// As many rays as accuracy-quick.toml has and the seed that configs have without one, so that its runs are
/// compared number by number.
const AccuracySettings settings{"contract", 1, 20'000};

int print_contract() {
  std::vector<AccuracyRecord> records;
  for (const Case& one : all_cases()) {
    for (const AccuracyBatch& batch : all_batches(one)) {
      for (AccuracyRecord& record : run_batch(batch, settings, [] { return false; }))
        records.push_back(std::move(record));
    }
    fmt::print(stderr, "{}\n", one.id);
  }
  fmt::print("{}", to_csv(Contract(AccuracyResults(std::move(records)))));
  return 0;
}

}  // namespace

}  // namespace raysweep

int main() { return raysweep::print_contract(); }
