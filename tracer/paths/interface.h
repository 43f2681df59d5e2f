// Where a ray meets the boundary of media: everything that it crosses at that place, taken together.
#pragma once

#include <array>
#include <span>

#include "tracer/accel/primitives.h"
#include "tracer/shade/media.h"

namespace raysweep {

/// The next thing on a ray's way that is to be shaded, with the media on both sides.
///
/// Surfaces closer together than their clearances cannot be told apart by rays that start there, so they are
/// one interface: between media that touch, with a gap of nothing or of an ulp, there is no film of what else
/// lies there; a solid thinner than that is a sheet with two faces. What is shaded does not depend on the
/// order that rounding gives the surfaces: something opaque before all, then the boundary of the highest
/// medium that the ray enters or leaves, then a sheet.
template <class T>
struct Interface {
  enum class Kind : unsigned char { nothing, sheet, boundary, opaque };

  Kind kind = Kind::nothing;
  Hit<T> hit;
  Surface<T> surface;
  T clearance;  // of all surfaces at this place
  MediumSet before, beyond;
  /// Primitives besides `hit` that take their share of what passes: other sheets, and second faces.
  std::array<uint32_t, 6> also_passed{};
  uint32_t also_count = 0;

  void pass_also(uint32_t primitive) {
    if (also_count < also_passed.size()) also_passed[also_count++] = primitive;
  }
};

template <class Core>
class InterfaceFinder {
 public:
  using T = typename Core::Real;
  using Kind = typename Interface<T>::Kind;

  InterfaceFinder(const Core& core, const Media& media) : core_(core), media_(media) {}

  /// The next interface along `ray`, which starts in `inside`; `inside` becomes the media where the ray
  /// leaves the scene if there is none.
  ///
  /// Two things that happen to one ray in some ten millions would let it leave the scene from inside of
  /// something: methods that are not watertight let it slip between two triangles; and where two solids cut
  /// through each other, a ray may start a clearance off the one and by that beyond the other. So such a ray
  /// tries again, from a little before its start, since to enter what one is in is nothing new; then with its
  /// direction moved by a few ulps.
  [[nodiscard]] std::optional<Interface<T>> next(const Ray<T>& ray, MediumSet& inside) const {
    const MediumSet start = inside;
    auto found = next_along(ray, inside);
    for (int attempt = 0; attempt < 4 && !found && !media_.may_end_in(inside); ++attempt) {
      const T shift = 16 * unit_roundoff<T>, back = 128 * unit_roundoff<T> * max_abs(ray.origin);
      const Vec3<T> aside(attempt == 1 ? shift : 0, attempt == 2 ? shift : 0, attempt == 3 ? shift : 0);
      const Vec3<T> direction = ray.direction + aside;
      inside = start;
      found = next_along({ray.origin - direction * back, direction}, inside);
    }
    return found;
  }

  /// The first interface after `last` among the hits of `ray` that `next_hit(last, t_max)` gives: the first
  /// one after `last` with t ≤ t_max. `last` becomes the last hit of it, `inside` the media before it.
  /// Boundaries inside a medium of higher rank are passed: nothing changes there.
  template <class NextHit>
  [[nodiscard]] std::optional<Interface<T>> next_among(const Ray<T>& ray, MediumSet& inside, Hit<T>& last,
                                                       NextHit&& next_hit) const {
    while (const auto hit = next_hit(last, std::numeric_limits<T>::infinity())) {
      const Place place = gather(ray, *hit, last, next_hit);
      const Interface<T> found = understand(place, inside);
      if (found.kind != Kind::nothing) return found;
      inside = found.beyond;
    }
    return std::nullopt;
  }

 private:
  struct Crossed {
    Hit<T> hit;
    Surface<T> surface;
    Media::Crossing crossing;
    uint32_t rank;
    bool entering;

    [[nodiscard]] bool is_boundary() const {
      return crossing == Media::Crossing::along || crossing == Media::Crossing::against;
    }
  };

  /// What a ray crosses at one place, in its order; something opaque ends it. What is more than fits counts
  /// as the next place.
  struct Place {
    std::array<Crossed, 12> crossed;
    size_t count = 0;
    T clearance = 0;

    [[nodiscard]] std::span<const Crossed> all() const { return {crossed.data(), count}; }
    /// How often more the medium of `rank` is entered than left.
    [[nodiscard]] int net_entries(uint32_t rank) const {
      int net = 0;
      for (const Crossed& c : all()) {
        if (c.is_boundary() && c.rank == rank) net += c.entering ? 1 : -1;
      }
      return net;
    }
  };

  [[nodiscard]] std::optional<Interface<T>> next_along(const Ray<T>& ray, MediumSet& inside) const {
    Hit<T> last = Hit<T>::start();
    return next_among(ray, inside, last,
                      [&](const Hit<T>& after, T t_max) { return core_.closest(ray, after, t_max); });
  }

  template <class NextHit>
  Place gather(const Ray<T>& ray, const Hit<T>& first, Hit<T>& last, NextHit&& next_hit) const {
    const auto& primitives = core_.primitives();
    const Surface<T> here = primitives.surface(ray, first);
    Place place;
    place.clearance = here.clearance;
    // The same place along the ray: as far as two clearances reach at this angle, and the rounding of t.
    const T cosine = std::max(std::abs(dot(here.normal, ray.direction)), unit_roundoff<T>);
    const T t_max = first.t * (1 + gamma_bound<T>(16)) + 4 * here.clearance / cosine;
    Surface<T> surface = here;
    for (std::optional<Hit<T>> hit = first; hit; hit = next_hit(last, t_max)) {
      if (place.count > 0) {
        surface = primitives.surface(ray, *hit);
        if (!(primitives.distance(hit->id, here.point) <= here.clearance + surface.clearance)) break;
        place.clearance = std::max(place.clearance, 2 * (here.clearance + surface.clearance));
      }
      const Media::Crossing crossing = media_.crossing(hit->id);
      const bool entering = surface.against == (crossing == Media::Crossing::against);
      place.crossed[place.count++] = {*hit, surface, crossing, media_.rank(hit->id), entering};
      last = *hit;
      if (crossing == Media::Crossing::opaque || place.count == place.crossed.size()) break;
    }
    return place;
  }

  [[nodiscard]] Interface<T> understand(const Place& place, const MediumSet& inside) const {
    Interface<T> found;
    found.before = found.beyond = inside;
    found.clearance = place.clearance;
    for (const Crossed& c : place.all()) {
      if (!c.is_boundary()) continue;
      const int net = place.net_entries(c.rank);
      if (net > 0) found.beyond.enter(c.rank);
      if (net < 0) found.beyond.leave(c.rank);
    }
    const auto choose = [&found](const Crossed& c, Kind kind) {
      found.kind = kind;
      found.hit = c.hit;
      found.surface = c.surface;
    };
    const Crossed& final = place.crossed[place.count - 1];
    if (final.crossing == Media::Crossing::opaque) {
      choose(final, Kind::opaque);
    } else if (found.beyond.top() != inside.top()) {
      const uint32_t highest = found.beyond.is_topped_by(inside.top()) ? inside.top() : found.beyond.top();
      choose(*std::ranges::find_if(place.all(),
                                   [&](const Crossed& c) { return c.is_boundary() && c.rank == highest; }),
             Kind::boundary);
    }
    add_sheets(place, inside, found, choose);
    return found;
  }

  /// Sheets, and solids that the ray enters and leaves here: the first is the interface if there is no other.
  template <class Choose>
  void add_sheets(const Place& place, const MediumSet& inside, Interface<T>& found, Choose&& choose) const {
    for (size_t i = 0; i < place.count; ++i) {
      const Crossed& c = place.crossed[i];
      const bool is_sheet = c.crossing == Media::Crossing::sheet;
      const bool is_thin_solid = c.is_boundary() && place.net_entries(c.rank) == 0 &&
                                 !inside.contains(c.rank) && inside.is_topped_by(c.rank);
      if (!is_sheet && !is_thin_solid) continue;
      // Two triangles of one sheet meet at an edge; a thin solid has two faces, both of which count.
      const auto before = place.all().first(i);
      const bool known = std::ranges::any_of(before, [&](const Crossed& b) {
        return b.crossing == c.crossing && b.rank == c.rank && (is_sheet || b.entering == c.entering);
      });
      if (known) continue;
      if (found.kind == Kind::nothing) {
        choose(c, Kind::sheet);
      } else {
        found.pass_also(c.hit.id);
      }
    }
  }

  const Core& core_;
  const Media& media_;
};

}  // namespace raysweep
