#include "experiments/intersection/tracer_cases.h"

namespace raysweep {

std::span<const TracerCase> tracer_cases() {
  static constexpr TracerCase cases[] = {
      {"W8", "the same hits on every instruction set, fused or not", "Embree issue 423",
       "tests/tracer/wide/wide_core_test.cpp"},
      {"F3", "camera a hundred times as far, field of view a hundredth", "mitsuba3 issue 61",
       "tests/tracer/far_camera_test.cpp"},
      {"N1", "ray in the plane of a box's face: 0 times infinity", "Ize 2013",
       "tests/tracer/robust_rays_test.cpp"},
      {"N3", "origin on a box's face, reciprocals clamped to finite numbers", "slabs with 1/d = 1e30",
       "tests/tracer/robust_rays_test.cpp"},
      {"N5", "work of axis-parallel rays in axis-aligned meshes", "bvh issue 21",
       "tests/tracer/robust_rays_test.cpp"},
      {"N7", "mesh of random bits", "this study", "tests/tracer/garbage_test.cpp"},
      {"P1", "the surface that a ray starts on", "Wachter & Binder 2019", "tests/tracer/spawn_test.cpp"},
      {"P2", "the next surface, a thousandth away", "offsets that do not know the scale",
       "tests/tracer/spawn_test.cpp"},
      {"P3", "duplicates and neighbours of the surface that a ray starts on", "exclusion by id",
       "tests/tracer/spawn_test.cpp"},
      {"V1", "hierarchies against brute force at edges and corners", "Ize 2013",
       "tests/tracer/robust_rays_test.cpp"},
      {"V2", "one ray in any lane of full, masked and partial packets", "approximate reciprocals",
       "tests/tracer/wide/lanes_test.cpp"},
      {"I1", "media nested, overlapping, touching and an ulp apart", "Schmidt & Budge 2002",
       "tests/tracer/media_test.cpp"},
  };
  return cases;
}

}  // namespace raysweep
