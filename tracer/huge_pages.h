// Large arrays in few pages.
#pragma once

#include <cstddef>

namespace raysweep {

/// From this size on an array is as likely as not to hold a huge page, which is 2 MiB on most machines,
/// whole.
inline constexpr size_t least_huge_array = size_t{3} << 20;

/// Asks the system to back as much of `memory` as it can with huge pages, which are much fewer to be set up
/// at the first touch and to be looked up later. A wish: nothing depends on whether it is granted.
void prefer_huge_pages(void* memory, size_t bytes);

}  // namespace raysweep
