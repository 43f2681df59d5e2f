// What accuracy experiments try: the variants of subjects.h, then what only other compilers and flags make.
#pragma once

#include "experiments/intersection/kernel.h"
#include "experiments/intersection/subjects.h"

namespace raysweep {

/// What a kernel says of each candidate. Its method, variant and precision are those of the kernel.
template <class T>
[[nodiscard]] Hits<T> hits_by(const Kernel<T>& kernel, const Trials<T>& trials);

/// `all_subjects`, each at its place; then of each method, as far as this machine has the modules, the base
/// variant with "contraction=on" and by the other compiler, "compiler=other".
template <class T>
[[nodiscard]] const std::vector<Subject<T>>& run_subjects();

/// `inapplicable_subjects`, and those that `run_subjects` lacks here.
[[nodiscard]] const std::vector<Inapplicable>& inapplicable_here();

}  // namespace raysweep
