// In place of kernel_timer.cpp where Google Benchmark was not found.
#include "experiments/errors.h"
#include "experiments/kernel_timer.h"

namespace raysweep {

std::string why_no_kernel_timer() {
  return "kernels are timed by Google Benchmark, which was not found when this was built; install "
         "libbenchmark-dev, then configure and build anew";
}

Timing time_passes(const std::vector<TimedPass>&, const TimingRequest&) {
  throw WorkError(why_no_kernel_timer());
}

}  // namespace raysweep
