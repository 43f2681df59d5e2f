#include "tracer/sample/point_sets.h"

namespace raysweep {

namespace {

/// The digits of `index` mirrored at the point: 6 = 110₂ gives 0.011₂ = 3/8.
double radical_inverse(int index, int base) {
  double inverse = 0, place = 1;
  for (; index > 0; index /= base) {
    place /= base;
    inverse += place * (index % base);
  }
  return inverse;
}

}  // namespace

/// Halton, "On the efficiency of certain quasi-random sequences of points…", Numerische Mathematik 2 (1960).
/// The sequence from index 0, moved right and down by half of 1/count: its first points else lean to the
/// upper left corner. No point leaves the pixel, for no radical inverse of the first n indices exceeds 1 −
/// 1/n. By the same bound, inside a stratum, none leaves its stratum: of 2^a·3^b points each of the boxes of
/// 2^a columns and 3^b rows holds one.
std::vector<Subpixel> make_halton(int count) {
  std::vector<Subpixel> points;
  for (int i = 0; i < count; ++i)
    points.push_back({radical_inverse(i, 2) + 0.5 / count, radical_inverse(i, 3) + 0.5 / count});
  return points;
}

}  // namespace raysweep
