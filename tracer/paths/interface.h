// Where a ray meets the boundary of media: everything that it crosses at that place, taken together.
#pragma once

#include "tracer/accel/primitives.h"
#include "tracer/shade/media.h"

namespace raysweep {

/// The first thing on a ray's way that is to be shaded, with the media on both sides. Surfaces closer
/// together than their clearances (media that touch, with a gap of nothing or of an ulp) cannot be told apart
/// by rays that start there; they are crossed at once, and no thin film of what lies between appears.
template <class T>
struct Interface {
  Hit<T> hit;
  Surface<T> surface;
  T clearance;  // of all surfaces at this place
  MediumSet before, beyond;
  bool is_opaque;
};

template <class Core>
class InterfaceFinder {
 public:
  using T = typename Core::Real;

  InterfaceFinder(const Core& core, const Media& media) : core_(core), media_(media) {}

  /// The next interface along `ray`, which starts in `inside`; `inside` becomes the media where the ray
  /// leaves the scene if there is none.
  ///
  /// Methods that are not watertight let one ray in some ten millions slip between two triangles. One that
  /// would leave the scene from inside of something has done so: it tries again with its direction moved by a
  /// few ulps.
  [[nodiscard]] std::optional<Interface<T>> next(const Ray<T>& ray, MediumSet& inside) const {
    const MediumSet start = inside;
    auto found = first_along(ray, inside);
    for (int axis = 0; axis < 3 && !found && !media_.may_end_in(inside); ++axis) {
      const T shift = 16 * unit_roundoff<T>;
      const Vec3<T> aside(axis == 0 ? shift : 0, axis == 1 ? shift : 0, axis == 2 ? shift : 0);
      inside = start;
      found = first_along({ray.origin, ray.direction + aside}, inside);
    }
    return found;
  }

 private:
  /// Boundaries inside a medium of higher rank are passed: nothing changes there.
  [[nodiscard]] std::optional<Interface<T>> first_along(const Ray<T>& ray, MediumSet& inside) const {
    Hit<T> last = Hit<T>::start();
    while (const auto hit = core_.closest(ray, last)) {
      Interface<T> found = at(ray, *hit, inside, last);
      if (found.is_opaque || is_sheet(found.hit.id) || found.before.top() != found.beyond.top()) return found;
      inside = found.beyond;
    }
    return std::nullopt;
  }

  [[nodiscard]] bool is_sheet(uint32_t id) const { return media_.crossing(id) == Media::Crossing::sheet; }

  /// All that the ray crosses at `first`; `last` becomes the last of it.
  Interface<T> at(const Ray<T>& ray, const Hit<T>& first, const MediumSet& inside, Hit<T>& last) const {
    const auto& primitives = core_.primitives();
    Interface<T> found{first, primitives.surface(ray, first), 0, inside, inside, false};
    found.clearance = found.surface.clearance;
    const Surface<T> here = found.surface;
    // The same place along the ray: as far as two clearances reach at this angle, and the rounding of t.
    const T cosine = std::max(std::abs(dot(here.normal, ray.direction)), unit_roundoff<T>);
    const T t_max = first.t * (1 + gamma_bound<T>(16)) + 4 * here.clearance / cosine;
    Surface<T> surface = here;
    bool relevant = false;
    for (std::optional<Hit<T>> hit = first; hit; hit = core_.closest(ray, last, t_max)) {
      if (hit->id != first.id || hit->t != first.t) {
        surface = primitives.surface(ray, *hit);
        if (!(primitives.distance(hit->id, here.point) <= here.clearance + surface.clearance)) break;
        found.clearance = std::max(found.clearance, 2 * (here.clearance + surface.clearance));
      }
      last = *hit;
      const bool opaque = primitives.is_opaque(hit->id), bounds = !opaque && !is_sheet(hit->id);
      if (bounds) media_.cross(found.beyond, hit->id, surface.against);
      // What is shaded: something opaque before all, else the first surface of a medium that counts here.
      const uint32_t rank = media_.rank(hit->id);
      const bool counts = opaque || (bounds && (rank == inside.top() || rank == found.beyond.top()));
      if (opaque || (counts && !relevant)) {
        relevant = true;
        found.hit = *hit;
        found.surface = surface;
      }
      if (opaque) {
        found.is_opaque = true;
        break;
      }
    }
    return found;
  }

  const Core& core_;
  const Media& media_;
};

}  // namespace raysweep
