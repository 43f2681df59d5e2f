// Whether neighbouring rays go together or alone.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace raysweep {

/// Rays that go together, if they do: neighbours in a batch, from multiples of this on.
inline constexpr size_t packet_size = 16;

/// About what steps of kernels take, in cycles, as measured with AVX-512.
struct StepCosts {
  // One ray that goes alone.
  static constexpr uint32_t ray = 45, ray_node = 17, ray_block = 38, ray_look = 60;
  // A packet.
  static constexpr uint32_t packet = 170, box = 40, node = 40, node_of_few = 65;
  /// A leaf, of whose triangles a beam meets about three; or the same for one ray after the other.
  static constexpr uint32_t leaf_together = 240, leaf_apart = 45, ray_apart = 45;
};

/// Chooses for each group of `packet_size` rays of one kind by what packets took of late and what their rays
/// would have taken alone, from batch to batch. The answers are the same either way.
class GroupChoice {
 public:
  /// Whether a group that could go together is to go alone so that it is known what that takes: a few, once.
  [[nodiscard]] bool explores() {
    if (ready_ == trusted + explored) return false;
    return ++ready_ > trusted;
  }

  /// Whether the next group is to go together. Where that has not paid, many go alone before it is tried
  /// again, twice as many each time that it still does not.
  [[nodiscard]] bool together() {
    if (gain_ >= 0) return true;
    if (++alone_ < pause_) return false;
    gain_ = alone_ = 0;
    pause_ = std::min(2 * pause_, most_alone);
    return false;
  }

  /// Tells what a packet took, in cycles.
  void went_together(uint32_t cycles) {
    gain_ = std::min(gain_ + worth_ - int64_t{cycles}, most_gain);
    if (gain_ > 0) pause_ = least_alone;
  }

  /// Tells what `rays` took that went alone, of which the last ten thousands count.
  void went_alone(uint64_t cycles, size_t rays) {
    constexpr uint64_t enough = 4096 * packet_size;
    cycles_ += cycles;
    rays_ += rays;
    if (rays_ > enough) {
      cycles_ /= 2;
      rays_ /= 2;
    }
    if (rays_ >= packet_size) worth_ = static_cast<int64_t>(cycles_ * packet_size / rays_);
  }

 private:
  static constexpr uint32_t trusted = 32, explored = 8, least_alone = 32, most_alone = 128;
  /// Of some hundred packets, so that one region where all rays take longer does not decide; what is trusted
  /// at first is less.
  static constexpr int64_t most_gain = 400'000, first_gain = 100'000;

  uint64_t cycles_ = 0, rays_ = 0;  // of rays that went alone
  int64_t worth_ = 5'000;           // what a packet saves; this until it is known
  int64_t gain_ = first_gain;
  uint32_t ready_ = 0, alone_ = 0, pause_ = least_alone;
};

}  // namespace raysweep
