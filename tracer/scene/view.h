// The camera, ready to send rays through pixels.
#pragma once

#include "tracer/math/ray.h"
#include "tracer/scene/scene.h"

namespace raysweep {

/// Morozov 2011: `x = 2·px/width − 1`, `y = 1 − 2·py/height`, scaled by the field of view, direction
/// `normalize(Cd + Cr·x + Cu·y)`. His third vector is called "left"; for x to grow rightwards it must point
/// right.
template <class T>
class View {
 public:
  View(const Camera& camera, int width, int height) : position_(camera.position) {
    const Vec3d forward = normalize(camera.target - camera.position);
    const Vec3d right = normalize(cross(forward, camera.up));
    const Vec3d up = cross(right, forward);
    const double half_height = std::tan(camera.half_angle), half_width = half_height * width / height;
    per_pixel_x_ = Vec3<T>(right * (2 * half_width / width));
    per_pixel_y_ = Vec3<T>(up * (-2 * half_height / height));
    corner_ = Vec3<T>(forward - right * half_width + up * half_height);
  }

  /// The ray through the point (px, py), in pixels from the picture's upper left corner.
  [[nodiscard]] Ray<T> through(T px, T py) const { return {position_, towards(px, py)}; }
  [[nodiscard]] const Vec3<T>& position() const { return position_; }
  /// That ray's direction.
  [[nodiscard]] Vec3<T> towards(T px, T py) const {
    return normalize(corner_ + per_pixel_x_ * px + per_pixel_y_ * py);
  }

 private:
  Vec3<T> position_, corner_, per_pixel_x_, per_pixel_y_;
};

}  // namespace raysweep
