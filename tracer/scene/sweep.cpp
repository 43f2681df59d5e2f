#include "tracer/scene/sweep.h"

#include <numbers>

namespace raysweep {

namespace {

uint32_t append_vertex(Mesh& mesh, const Vec3d& p) {
  mesh.vertices.emplace_back(p);
  return static_cast<uint32_t>(mesh.vertices.size() - 1);
}

double power_keeping_sign(double x, double exponent) {
  return std::copysign(std::pow(std::abs(x), exponent), x);
}

/// The `around` corners of a superellipse (Lamé curve).
uint32_t append_section(Mesh& mesh, const Section& s, int around) {
  const auto first = static_cast<uint32_t>(mesh.vertices.size());
  for (int i = 0; i < around; ++i) {
    const double angle = 2 * std::numbers::pi * (i + 0.5) / around;
    append_vertex(mesh, s.centre + s.half_a * power_keeping_sign(std::cos(angle), 2 / s.squareness) +
                            s.half_b * power_keeping_sign(std::sin(angle), 2 / s.squareness));
  }
  return first;
}

void append_quad(Mesh& mesh, uint32_t a, uint32_t b, uint32_t c, uint32_t d) {
  mesh.triangles.push_back({a, b, c});
  mesh.triangles.push_back({a, c, d});
}

void append_band(Mesh& mesh, uint32_t from, uint32_t to, int around) {
  for (int i = 0; i < around; ++i) {
    const auto here = static_cast<uint32_t>(i), next = static_cast<uint32_t>((i + 1) % around);
    append_quad(mesh, from + here, from + next, to + next, to + here);
  }
}

void append_cap(Mesh& mesh, uint32_t first, int around, bool outwards_is_back) {
  for (int i = 1; i + 1 < around; ++i) {
    const uint32_t a = first, b = first + static_cast<uint32_t>(i), c = b + 1;
    if (outwards_is_back) {
      mesh.triangles.push_back({a, c, b});
    } else {
      mesh.triangles.push_back({a, b, c});
    }
  }
}

}  // namespace

void append_tube(Mesh& mesh, const Path& path, int around, int along) {
  uint32_t previous = append_section(mesh, path(0), around);
  append_cap(mesh, previous, around, true);
  for (int k = 1; k <= along; ++k) {
    const uint32_t next = append_section(mesh, path(static_cast<double>(k) / along), around);
    append_band(mesh, previous, next, around);
    previous = next;
  }
  append_cap(mesh, previous, around, false);
}

void append_ring(Mesh& mesh, const Path& path, int around, int along) {
  const uint32_t first = append_section(mesh, path(0), around);
  uint32_t previous = first;
  for (int k = 1; k < along; ++k) {
    const uint32_t next = append_section(mesh, path(static_cast<double>(k) / along), around);
    append_band(mesh, previous, next, around);
    previous = next;
  }
  append_band(mesh, previous, first, around);
}

void append_sheet(Mesh& mesh, const std::function<Vec3d(double u, double v)>& point, int across, int along) {
  const auto first = static_cast<uint32_t>(mesh.vertices.size());
  for (int j = 0; j <= along; ++j) {
    for (int i = 0; i <= across; ++i) {
      append_vertex(mesh, point(static_cast<double>(i) / across, static_cast<double>(j) / along));
    }
  }
  const auto columns = static_cast<uint32_t>(across), rows = static_cast<uint32_t>(along),
             stride = columns + 1;
  for (uint32_t j = 0; j < rows; ++j) {
    for (uint32_t i = 0; i < columns; ++i) {
      const uint32_t a = first + j * stride + i;
      if (i == 0 && j == 0) {
        mesh.triangles.push_back({a + 1, a + 1 + stride, a + stride});
      } else {
        append_quad(mesh, a, a + 1, a + 1 + stride, a + stride);
      }
    }
  }
}

}  // namespace raysweep
