// Whether neighbouring rays go together or alone.
#pragma once

#include <algorithm>
#include <cstdint>

namespace raysweep {

/// About how many cycles groups of rays took whose rays went alone; of the last thousands of groups.
struct GroupCost {
  uint64_t cycles = 0, groups = 0;

  /// What a single ray takes, as measured with AVX-512 on `pebble`.
  static constexpr uint64_t of_node = 17, of_block = 38, of_ray = 45;

  void add(uint64_t more_cycles, uint64_t more_groups) {
    constexpr uint64_t enough = 4096;
    cycles += more_cycles;
    groups += more_groups;
    if (groups > enough) {
      cycles /= 2;
      groups /= 2;
    }
  }
};

/// Chooses for each group by what packets gained and lost of late. A packet meets nodes, blocks and
/// triangles, a step each; one that ends within its budget saved what its rays would have taken alone, one
/// that gives up took its steps for nothing. The answers are the same either way. A choice is one batch's: in
/// short ones, of less than some hundred groups, all are tried together.
class GroupChoice {
 public:
  GroupChoice(const GroupCost& alone, int32_t budget)
      : worth_(alone.groups > 0 ? static_cast<int32_t>(alone.cycles / alone.groups / cycles_per_step)
                                : 2 * budget),
        most_gain_(20 * budget),
        gain_(most_gain_) {}

  /// Whether the next group is to go together. Where that has not paid, many go alone before it is tried
  /// again.
  [[nodiscard]] bool together() {
    if (gain_ >= 0) return true;
    if (++alone_ == most_alone) gain_ = alone_ = 0;
    return false;
  }

  void ended(int32_t steps) { gain_ = std::min(gain_ + worth_ - steps, most_gain_); }
  void gave_up(int32_t steps) { gain_ -= steps; }

 private:
  static constexpr uint64_t cycles_per_step = 22;
  static constexpr int32_t most_alone = 32;

  const int32_t worth_, most_gain_;
  int32_t gain_, alone_ = 0;
};

}  // namespace raysweep
