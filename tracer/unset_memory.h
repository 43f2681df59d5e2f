// Arrays that are filled right after they are made, by whoever shares that work: to set them to nothing
// before would touch all of their memory once more, from one thread.
#pragma once

#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

#include "tracer/film.h"
#include "tracer/huge_pages.h"

namespace raysweep {

/// Elements made without a value stay what the memory held.
template <class T>
struct UnsetAllocator : CacheLineAllocator<T> {
  UnsetAllocator() = default;
  template <class U>
  explicit UnsetAllocator(const UnsetAllocator<U>&) {}

  T* allocate(size_t n) {
    T* const memory = CacheLineAllocator<T>::allocate(n);
    if (n * sizeof(T) >= least_huge_array) prefer_huge_pages(memory, n * sizeof(T));
    return memory;
  }

  template <class U, class... Values>
  void construct(U* where, Values&&... values) {
    static_assert(std::is_trivially_copyable_v<U>);
    if constexpr (sizeof...(Values) > 0) std::construct_at(where, std::forward<Values>(values)...);
  }
};

template <class T>
using UnsetVector = std::vector<T, UnsetAllocator<T>>;

}  // namespace raysweep
