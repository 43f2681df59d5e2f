// Whether neighbouring rays go together or alone.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace raysweep {

/// Rays that go together, if they do: neighbours in a batch, from multiples of this on.
inline constexpr size_t packet_size = 16;

/// Chooses for each group of `packet_size` rays of one kind by what packets gained and lost of late, from
/// batch to batch. A packet meets nodes, blocks and triangles, a step each; one that ends within its budget
/// saved what its rays would have taken alone, one that gives up took its steps for nothing. The answers are
/// the same either way.
class GroupChoice {
 public:
  /// Steps that a packet may take: about what costs as much as 16 single rays on `pebble`. Hardly a packet of
  /// camera rays takes that many, of shadow rays about one in six (results/recorded/vm/limits.md).
  static constexpr int32_t budget = 96;
  /// About what a single ray takes, in cycles, as measured with AVX-512 on `pebble`.
  static constexpr uint64_t cycles_of_node = 17, cycles_of_block = 38, cycles_of_ray = 45;

  /// Whether the next group is to go together. Where that has not paid, many go alone before it is tried
  /// again.
  [[nodiscard]] bool together() {
    if (gain_ >= 0) return true;
    if (++alone_ == most_alone) gain_ = alone_ = 0;
    return false;
  }

  void ended(int32_t steps) { gain_ = std::min(gain_ + worth_ - steps, most_gain); }
  void gave_up(int32_t steps) { gain_ -= steps; }

  /// Tells what `rays` took that went alone, of which the last ten thousands count.
  void went_alone(uint64_t cycles, size_t rays) {
    constexpr uint64_t enough = 4096 * packet_size;
    cycles_ += cycles;
    rays_ += rays;
    if (rays_ > enough) {
      cycles_ /= 2;
      rays_ /= 2;
    }
    if (rays_ >= packet_size) worth_ = static_cast<int32_t>(cycles_ * packet_size / rays_ / cycles_per_step);
  }

 private:
  static constexpr uint64_t cycles_per_step = 22;
  static constexpr int32_t most_gain = 20 * budget, most_alone = 32;

  uint64_t cycles_ = 0, rays_ = 0;  // of rays that went alone
  int32_t worth_ = 2 * budget;      // steps that a packet saves; this until it is known
  int32_t gain_ = most_gain, alone_ = 0;
};

}  // namespace raysweep
