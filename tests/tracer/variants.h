// Every way of computing a picture, for tests that hold in all of them.
#pragma once

#include <string>
#include <vector>

#include "tests/tracer/scene_sizes.h"
#include "tracer/render.h"

namespace raysweep {

/// The core wide computes in float only.
inline bool goes_with(std::string_view core, std::string_view precision) {
  return core != "wide" || precision == "float";
}

/// Each core, precision, method and hierarchy, for a picture of one pixel.
inline std::vector<RenderSettings> all_variants() {
  std::vector<RenderSettings> list;
  for (const Choice& core : cores()) {
    for (const Choice& precision : precisions()) {
      for (const Choice& method : methods()) {
        for (const Choice& accel : accels()) {
          if (!goes_with(core.name, precision.name)) continue;
          RenderSettings s;
          s.width = s.height = 1;
          s.core = core.name;
          s.precision = precision.name;
          s.method = method.name;
          s.accel = accel.name;
          list.push_back(s);
        }
      }
    }
  }
  return list;
}

/// Of the built-in scenes that can be rendered in every variant.
inline std::vector<std::string> scene_names() {
  std::vector<std::string> names;
  for (const BuiltInScene& scene : scenes_up_to(brute_force_triangles)) names.emplace_back(scene.name);
  return names;
}

/// The whole picture.
inline Film picture_of(const Scene& scene, const RenderSettings& settings, RenderCounts* counts = nullptr) {
  Film film(settings.width, settings.height);
  const RenderCounts made =
      make_renderer(scene, settings)->render({0, 0, settings.width, settings.height}, film);
  if (counts) *counts = made;
  return film;
}

}  // namespace raysweep
