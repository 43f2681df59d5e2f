// How the constants of triangles lie in memory.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace raysweep {

/// One after the other; each of their numbers in an array of its own; blocks of as many as there are lanes,
/// or of eight where a triangle is tested alone, in which the same numbers lie side by side.
enum class Layout { aos, soa, blocks };

[[nodiscard]] constexpr std::string_view name_of(Layout layout) {
  return layout == Layout::aos ? "aos" : layout == Layout::soa ? "soa" : "blocks";
}

/// A list of `Constants`, of which each is `sizeof(Number)` times some count long, read one at a time. A
/// dropped axis, which is no number, goes with the others by its bytes.
template <class Constants, class Number, Layout layout>
class ConstantList {
 public:
  explicit ConstantList(const std::vector<Constants>& all) : count_(all.size()) {
    numbers_.resize((count_ + block_size - 1) / block_size * block_size * number_count);
    for (size_t i = 0; i < count_; ++i) {
      const auto numbers = std::bit_cast<Numbers>(all[i]);
      for (size_t k = 0; k < number_count; ++k) numbers_[place(i, k)] = numbers[k];
    }
  }

  [[nodiscard]] Constants operator[](size_t i) const {
    Numbers numbers;
    [&]<size_t... k>(std::index_sequence<k...>) { ((numbers[k] = numbers_[place(i, k)]), ...); }
    (std::make_index_sequence<number_count>());
    return std::bit_cast<Constants>(numbers);
  }

 private:
  static constexpr size_t block_size = 8;
  static constexpr size_t number_count = sizeof(Constants) / sizeof(Number);
  using Numbers = std::array<Number, number_count>;
  static_assert(sizeof(Numbers) == sizeof(Constants) && std::is_trivially_copyable_v<Constants>);

  /// Of number `k` of triangle `i`.
  [[nodiscard]] size_t place(size_t i, size_t k) const {
    if constexpr (layout == Layout::soa) return k * count_ + i;
    return (i / block_size * number_count + k) * block_size + i % block_size;
  }

  size_t count_;
  std::vector<Number> numbers_;
};

/// Where they lie one after the other, they are read where they are.
template <class Constants, class Number>
class ConstantList<Constants, Number, Layout::aos> {
 public:
  explicit ConstantList(std::vector<Constants> all) : all_(std::move(all)) {}
  [[nodiscard]] const Constants& operator[](size_t i) const { return all_[i]; }

 private:
  std::vector<Constants> all_;
};

}  // namespace raysweep
