#include "tracer/scene/chair.h"

#include <cmath>
#include <numbers>

#include "tracer/scene/sweep.h"

namespace raysweep {

namespace {

constexpr double seat_height = 0.45, seat_half_width = 0.225, seat_half_depth = 0.215;
constexpr double back_foot = 0.2;     // how far the back posts stand behind the middle
constexpr double back_width = 0.185;  // half the distance between the posts
constexpr double top = 0.96;

/// The back's curved surface: leans back with height, bows backwards in the middle; below the seat the posts
/// splay out.
Vec3d back_at(double x, double y) {
  const double up = (y - seat_height) / (top - seat_height);
  const double lean = up > 0 ? 0.1 * std::pow(up, 1.4) : 0.05 * up * up;
  const double bow = up > 0 ? 0.045 * up * (1 - x * x / (back_width * back_width)) : 0;
  return {x, y, -back_foot - lean - bow};
}

/// A round bar between two points, thicker in the middle by `swell`.
Path bar(const Vec3d& from, const Vec3d& to, double radius, double swell) {
  const Vec3d along = normalize(to - from);
  const Vec3d a = normalize(cross(along, std::abs(along.y) > 0.9 ? Vec3d(0, 0, 1) : Vec3d(0, 1, 0)));
  const Vec3d b = cross(along, a);
  return [=](double u) {
    const double r = radius * (1 + swell * std::sin(std::numbers::pi * u));
    return Section{from + (to - from) * u, a * r, b * r};
  };
}

/// A turned front leg: a foot, a taper, and a ring below the seat.
Path front_leg(double x) {
  return [=](double u) {
    const double y = 0.44 * u;
    const double ring =
        0.006 * std::exp(-std::pow((u - 0.82) / 0.03, 2)) + 0.004 * std::exp(-std::pow(u / 0.05, 2));
    const double r = 0.013 + 0.010 * u + ring;
    return Section{{x * (1.06 - 0.06 * u), y, 0.185 + 0.012 * (1 - u)}, {r, 0, 0}, {0, 0, r}};
  };
}

/// A back post from floor to top rail, following the back's curve.
Path back_post(double side) {
  return [=](double u) {
    const double y = top * u;
    const double r = 0.019 - 0.006 * u;
    Vec3d centre = back_at(back_width, y);
    centre.x = side * (back_width + 0.012 * (1 - u));
    return Section{centre, {r, 0, 0}, {0, 0, 1.15 * r}, 2.6};
  };
}

/// A board across the back at height `y`; `overhang` past the posts.
Path back_rail(double y, double half_height, double half_thickness, double overhang) {
  return [=](double u) {
    const double x = (back_width + overhang) * (2 * u - 1);
    const double inside = std::min(1.0, std::abs(x) / back_width);
    Vec3d centre = back_at(back_width * inside, y);
    centre.x = x;
    const double arch = 0.25 * half_height * (1 - (2 * u - 1) * (2 * u - 1));
    return Section{centre + Vec3d(0, arch, 0), {0, half_height + arch, 0}, {0, 0, half_thickness}, 3.5};
  };
}

Path spindle(double x) {
  return [=](double u) {
    const double y = 0.575 + (0.925 - 0.575) * u;
    const double r = 0.0065 + 0.0035 * std::sin(std::numbers::pi * u);
    return Section{back_at(x, y), {r, 0, 0}, {0, 0, r}};
  };
}

/// The seat's rim at `angle`: a superellipse, a little narrower at the back.
Vec3d rim(double angle, double scale) {
  const double c = std::cos(angle), s = std::sin(angle);
  const double x = std::copysign(std::pow(std::abs(c), 0.5), c),
               z = std::copysign(std::pow(std::abs(s), 0.5), s);
  return {scale * seat_half_width * x * (1 + 0.06 * z), seat_height, scale * seat_half_depth * z};
}

Section seat_frame(double u) {
  const double angle = 2 * std::numbers::pi * u;
  const Vec3d centre = rim(angle, 1);
  const Vec3d outwards = normalize(Vec3d(centre.x, 0, centre.z));
  return {centre, outwards * 0.019, {0, 0.02, 0}, 4};
}

/// The woven seat inside the frame: strands alternate over and under, the middle sags by 12 mm.
Vec3d weave(double u, double v, int cells) {
  const double x = 2 * u - 1, z = 2 * v - 1;
  const double scale = std::max(std::abs(x), std::abs(z));  // squares around the middle become rims around it
  const int i = static_cast<int>(std::lround(u * cells)), j = static_cast<int>(std::lround(v * cells));
  Vec3d p = rim(std::atan2(z, x), scale);
  p.y += 0.012 - 0.012 * (1 - scale * scale) + ((i + j) % 2 == 0 ? 0.0015 : -0.0015);
  return p;
}

}  // namespace

// Triangles: front legs 2·1004/2, back posts 2·1388/2, seat frame 768, top rail 540, lower rail 308, spindles
// 5·140, stretchers 2·96 + 176 + 150, seat 2·40² − 1 = 3199: 10,817 in all.
Chair make_chair() {
  Chair chair;
  Mesh& frame = chair.frame;
  frame.name = "chair frame";
  for (const double side : {-1.0, 1.0}) {
    append_tube(frame, front_leg(side * 0.195), 24, 20);
    append_tube(frame, back_post(side), 24, 28);
    append_tube(frame,
                bar({side * 0.2, 0.2, 0.19}, back_at(back_width, 0.22) + Vec3d((side - 1) * back_width, 0, 0),
                    0.0085, 0.3),
                10, 4);
  }
  append_ring(frame, seat_frame, 12, 32);
  append_tube(frame, back_rail(0.94, 0.034, 0.011, 0.025), 16, 16);
  append_tube(frame, back_rail(0.575, 0.014, 0.009, 0), 12, 12);
  for (int i = -2; i <= 2; ++i) append_tube(frame, spindle(0.058 * i), 8, 8);
  append_tube(frame, bar({-0.2, 0.28, 0.19}, {0.2, 0.28, 0.19}, 0.0085, 0.35), 10, 8);
  append_tube(frame, bar({-back_width, 0.28, -0.21}, {back_width, 0.28, -0.21}, 0.0085, 0.3), 11, 6);

  constexpr int cells = 40;
  chair.seat.name = "woven seat";
  append_sheet(
      chair.seat, [](double u, double v) { return weave(u, v, cells); }, cells, cells);
  return chair;
}

}  // namespace raysweep
