// How a run of an accuracy experiment compares with what its methods promise.
#pragma once

#include "results/contract.h"
#include "results/tables/table.h"

namespace raysweep {

/// How many cells of each method and precision keep what is stated of them, break it, or do better than
/// stated; a cell that does both is broken. Cells that the contract does not know stand apart.
[[nodiscard]] Table contract_table(const AccuracyResults& results, const Contract& contract);

/// Every number that is not as stated, one row each: first what is broken, then what is better.
[[nodiscard]] Table contract_differences_table(const AccuracyResults& results, const Contract& contract);

}  // namespace raysweep
