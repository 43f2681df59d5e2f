// `render(tile)`: the one unit of work. Colour is a function of scene, settings and pixel, and of nothing
// else.
#pragma once

#include <cstdint>
#include <memory>

#include "tracer/film.h"
#include "tracer/scene/scene.h"
#include "tracer/settings.h"

namespace raysweep {

/// Rays by what sent them out.
struct RayCounts {
  uint64_t primary = 0, shadow = 0, reflected = 0, refracted = 0;

  [[nodiscard]] uint64_t total() const { return primary + shadow + reflected + refracted; }
  RayCounts& operator+=(const RayCounts& other) {
    primary += other.primary;
    shadow += other.shadow;
    reflected += other.reflected;
    refracted += other.refracted;
    return *this;
  }
  friend bool operator==(const RayCounts&, const RayCounts&) = default;
};

/// Pixels `x … x + width − 1`, `y … y + height − 1`, counted from the picture's upper left corner.
struct Tile {
  int x, y, width, height;
};

/// A scene prepared for rendering in one way: compiled geometry, hierarchy, camera, pattern. Immutable, so
/// any number of threads may render different tiles at once.
class Renderer {
 public:
  virtual ~Renderer() = default;
  /// Writes the tile's pixels into `film`, which must have the settings' size. One virtual call a tile.
  virtual RayCounts render(const Tile& tile, Film& film) const = 0;
};

/// Builds geometry and hierarchy. Throws std::invalid_argument if a name in `settings` is unknown.
[[nodiscard]] std::unique_ptr<const Renderer> make_renderer(const Scene& scene,
                                                            const RenderSettings& settings);

}  // namespace raysweep
