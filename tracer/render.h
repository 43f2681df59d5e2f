// `render(tile)`: the one unit of work. Colour is a function of scene, settings and pixel, and of nothing
// else.
#pragma once

#include <cstdint>
#include <memory>

#include "tracer/film.h"
#include "tracer/render_counts.h"
#include "tracer/scene/scene.h"
#include "tracer/settings.h"

namespace raysweep {

/// Pixels `x … x + width − 1`, `y … y + height − 1`, counted from the picture's upper left corner.
struct Tile {
  int x, y, width, height;
};

/// Memory that a renderer works in, kept from tile to tile: whoever renders many tiles one after the other
/// makes it once, so that no tile waits for an allocation. Two cache lines of its own, lest what one worker
/// counts in it slows another (prefetchers fetch lines in pairs).
class alignas(128) Workspace {
 public:
  Workspace() = default;
  Workspace(const Workspace&) = delete;
  Workspace& operator=(const Workspace&) = delete;
  virtual ~Workspace() = default;
};

/// A scene prepared for rendering in one way: compiled geometry, hierarchy, camera, pattern. Immutable, so
/// any number of threads may render different tiles at once, each with a workspace of its own.
class Renderer {
 public:
  virtual ~Renderer() = default;
  [[nodiscard]] virtual std::unique_ptr<Workspace> make_workspace() const = 0;
  /// Writes the tile's pixels into `film`, which must have the settings' size. One virtual call a tile.
  /// `workspace` is of this renderer's making; no colour depends on what it has been used for before.
  virtual RenderCounts render(const Tile& tile, Film& film, Workspace& workspace) const = 0;
  /// The same for one tile alone.
  RenderCounts render(const Tile& tile, Film& film) const { return render(tile, film, *make_workspace()); }
  /// Id of the primitive that the ray through the centre of pixel (x, y) meets first, or `no_hit_id`.
  [[nodiscard]] virtual uint32_t first_hit(int x, int y) const = 0;
};

/// Builds geometry and hierarchy. Throws std::invalid_argument if a name in `settings` is unknown or a
/// material is not one.
[[nodiscard]] std::unique_ptr<const Renderer> make_renderer(const Scene& scene,
                                                            const RenderSettings& settings);

}  // namespace raysweep
