// All rows, each in a process of its own.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "experiments/overhead/tables.h"

namespace raysweep {

/// How a row is measured between two calibrations of busy work. The program starts itself anew; tests may
/// make rows up.
using MeasureRow =
    std::function<RowSamples(const Subject&, const std::string& parts, const WorkSpeed& speed)>;

/// The rows of `subjects`, in order. A row that fails is kept, with its reason. Ends early when interrupted.
[[nodiscard]] std::vector<OverheadRow> measure_rows(const std::vector<Subject>& subjects,
                                                    const std::string& parts, const MeasureRow& measure);

/// Starts this program's verb `row` for it, beside a busy process if that is asked for. Throws WorkError if
/// the row's process dies.
[[nodiscard]] RowSamples measure_in_a_child(const Subject& subject, const std::string& parts,
                                            const WorkSpeed& speed, double seconds);

/// Uses a processor until standard input is closed, or the process killed.
void be_busy();

/// Refuses an environment that decides how workers wait, behind the back of what the tables say of it. Throws
/// RequestError.
void refuse_waiting_environment();

}  // namespace raysweep
