// The media that a point lies in.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

namespace raysweep {

/// Media around a point, each named by its rank. Where media overlap, that of the highest rank is there
/// (Schmidt & Budge 2002, "Simple nested dielectrics in ray traced images"): what a boundary divides then
/// does not depend on the order in which boundaries were crossed, and a crossing inside a higher medium
/// changes nothing.
///
/// A set, not a stack: entering twice, as a ray does through an edge that two triangles share, is entering
/// once.
class MediumSet {
 public:
  static constexpr uint32_t outside = ~0u;
  static constexpr size_t capacity = 30;

  [[nodiscard]] auto begin() const { return ranks_.begin(); }
  [[nodiscard]] auto end() const { return ranks_.begin() + count_; }

  void enter(uint32_t rank) {
    const auto end = ranks_.begin() + count_;
    const auto place = std::find_if(ranks_.begin(), end, [&](uint32_t r) { return r <= rank; });
    if (place != end && *place == rank) return;
    overflowed_ = overflowed_ || count_ == capacity;
    if (place == ranks_.end()) return;
    const auto last = count_ < capacity ? end : end - 1;
    std::copy_backward(place, last, last + 1);
    *place = rank;
    count_ = std::min<uint32_t>(count_ + 1, capacity);
  }
  void leave(uint32_t rank) {
    const auto end = ranks_.begin() + count_;
    const auto place = std::find(ranks_.begin(), end, rank);
    if (place == end) return;
    std::copy(place + 1, end, place);
    count_--;
  }
  [[nodiscard]] bool contains(uint32_t rank) const { return std::find(begin(), end(), rank) != end(); }
  [[nodiscard]] bool empty() const { return count_ == 0; }
  [[nodiscard]] size_t size() const { return count_; }
  /// Rank of the medium that is there, or `outside`.
  [[nodiscard]] uint32_t top() const { return count_ == 0 ? outside : ranks_[0]; }
  /// Whether the medium of `rank`, which may be `outside`, would be there if it were added.
  [[nodiscard]] bool is_topped_by(uint32_t rank) const {
    return rank != outside && (count_ == 0 || rank > ranks_[0]);
  }
  /// Whether there ever were more media than fit; the lowest ones were then forgotten.
  [[nodiscard]] bool overflowed() const { return overflowed_; }

 private:
  std::array<uint32_t, capacity> ranks_{};  // descending
  uint32_t count_ = 0;
  bool overflowed_ = false;
};

}  // namespace raysweep
