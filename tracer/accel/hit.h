// The nearest thing that a ray meets.
#pragma once

#include <cstdint>
#include <limits>

namespace raysweep {

/// A meeting at distance `t` with primitive `id`. All meetings of one ray stand in one order, the same in
/// every core: by distance, of equals by id.
template <class T>
struct Hit {
  T t;
  uint32_t id;

  /// The one rule of all cores: of two hits at equal `t` the lower id wins.
  [[nodiscard]] bool before(const Hit& other) const { return t < other.t || (t == other.t && id < other.id); }
  /// What every hit with t ≤ `t_max` comes before.
  [[nodiscard]] static constexpr Hit none(T t_max = std::numeric_limits<T>::infinity()) {
    return {t_max, ~0u};
  }
  [[nodiscard]] bool is_none() const { return id == ~0u; }
  /// What every hit with t > 0, and no other, comes after.
  [[nodiscard]] static constexpr Hit start() { return {0, ~0u}; }
};

/// `core.visit_hits` by asking for one hit after the other: shows each once, however many leaves it is in.
template <class Core, class Ray, class T, class Visit>
bool visit_in_order(const Core& core, const Ray& ray, T t_max, Visit&& visit) {
  auto hit = core.closest(ray, Hit<T>::start(), t_max);
  for (; hit && hit->t < t_max; hit = core.closest(ray, *hit, t_max))
    if (visit(*hit)) return true;
  return false;
}

}  // namespace raysweep
