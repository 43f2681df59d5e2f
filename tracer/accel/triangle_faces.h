// Faces of many triangles at once.
#pragma once

#include "tracer/accel/triangle_face.h"

namespace raysweep {

inline constexpr size_t faces_at_once = 16;

/// `faces_of`, with the widest vectors that the machine has.
template <class T>
[[nodiscard]] std::array<TriangleFace<T>, faces_at_once> wide_faces_of(
    const std::array<Triangle<T>, faces_at_once>& triangles) {
  return faces_of(triangles);
}
template <>
[[nodiscard]] std::array<TriangleFace<float>, faces_at_once> wide_faces_of(
    const std::array<Triangle<float>, faces_at_once>& triangles);

}  // namespace raysweep
