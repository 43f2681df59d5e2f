// Every method on a case, number by number as the contract states it.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "experiments/intersection/accuracy.h"
#include "results/contract.h"

namespace raysweep {

/// The contract of the project.
inline const Contract& contract() {
  static const Contract kept = Contract::read(RAYSWEEP_SOURCE_DIR "/experiments/intersection/contract.csv");
  return kept;
}

/// One line for each number that is not as stated, or that is not stated at all.
inline std::vector<std::string> differences(const AccuracyRecord& record) {
  const Clause* clause = contract().clause_of(record);
  if (!clause) return {record.cell + ": not stated"};
  Clause other = *clause;
  // Arc tangents are the C library's own: these numbers are compared as those of other rays are.
  if (record.method == "angle_sum") ++other.rays;
  const std::vector<Judgement> judgements = judge(record, other);
  if (judgements.empty()) return {record.cell + ": its level is not stated"};
  std::vector<std::string> list;
  for (const Judgement& one : judgements) {
    if (one.outcome == Outcome::kept) continue;
    list.push_back(record.cell + ", " + std::string(one.what) + ": stated " + std::to_string(one.stated) +
                   ", found " + std::to_string(one.found) + ", " + std::string(name_of(one.outcome)));
  }
  return list;
}

/// Runs a batch with the rays that the contract was recorded with.
inline void expect_as_stated(const AccuracyBatch& batch) {
  const Clause& any = contract().clauses().front();
  const AccuracySettings settings{"contract", any.seed, any.rays};
  for (const AccuracyRecord& record : run_batch(batch, settings, [] { return false; })) {
    for (const std::string& line : differences(record)) ADD_FAILURE() << line;
  }
}

/// All cases by index; their ids as names of tests.
class ContractOf : public testing::TestWithParam<size_t> {};
inline std::string case_name(const testing::TestParamInfo<size_t>& info) {
  return std::string(all_cases()[info.param].id);
}

}  // namespace raysweep
