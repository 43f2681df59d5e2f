// From the name of a builder to its hierarchy.
#pragma once

#include <stdexcept>
#include <string>

#include "tracer/accel/hierarchy.h"

namespace raysweep {

/// The hierarchy that `accel` names; an empty one for "none". The first `sphere_count` items are spheres,
/// which are not cut: kernels test them one by one, so that each piece would cost a whole test. `block`,
/// `for_each`: see build_sah. Throws std::invalid_argument for another name.
template <class T>
[[nodiscard]] Hierarchy<T> build_by_name(const std::string& accel, std::span<const Box<T>> items,
                                         uint32_t sphere_count, int leaf_size, int block = 1,
                                         const ForEach& for_each = one_after_the_other) {
  if (accel == "sah") return build_sah(items, leaf_size, block, for_each);
  if (accel == "sbvh")
    return build_sbvh(items, CutOptions{.whole_count = sphere_count}, leaf_size, block, for_each);
  if (accel == "median") return build_median(items, leaf_size);
  if (accel == "none") return {};
  throw std::invalid_argument("unknown accel \"" + accel + "\"");
}

}  // namespace raysweep
