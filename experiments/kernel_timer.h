// Times passes of kernels.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace raysweep {

class KernelPass;

struct TimingRequest {
  std::string name;
  int samples = 1;
  double min_seconds = 0;   // a sample, where passes are not given
  uint64_t iterations = 0;  // passes a sample; 0: as many as `min_seconds` needs
};

struct Timing {
  uint64_t iterations = 0;        // passes a sample
  std::vector<double> seconds{};  // a sample each
};

/// Why nothing can be timed in this build; empty if it can.
[[nodiscard]] std::string why_no_kernel_timer();

/// Times passes, each thread running one of `passes` as often as the others, after one that is not timed. Of
/// one thread processor time is told, which other programs change least; of several wall time, in which one
/// waits for the other. Not where `why_no_kernel_timer` says why.
[[nodiscard]] Timing time_passes(const std::vector<std::unique_ptr<KernelPass>>& passes,
                                 const TimingRequest& request);

}  // namespace raysweep
