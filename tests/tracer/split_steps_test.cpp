// What is compiled for the machine's widest vectors finds what plain code finds.
#include "tracer/accel/split_steps.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

#include "tracer/accel/triangle_faces.h"

namespace raysweep {
namespace {

template <class Vector>
bool same_lanes(const Vector& a, const Vector& b) {
  return a[0] == b[0] && a[1] == b[1] && a[2] == b[2] && a[3] == b[3];
}
template <class T>
bool are_equal(const LaneBox<T>& a, const LaneBox<T>& b) {
  return same_lanes(a.lower, b.lower) && same_lanes(a.upper, b.upper);
}
template <class T>
bool are_equal(const std::vector<Reference<T>>& a, const std::vector<Reference<T>>& b) {
  return std::ranges::equal(a, b, [](const Reference<T>& x, const Reference<T>& y) {
    return same_lanes(x.lower, y.lower) && same_lanes(x.upper, y.upper);
  });
}

template <class T>
std::vector<Reference<T>> random_references(size_t count) {
  std::mt19937 random(5);
  std::uniform_real_distribution<T> place(-3, 4), size(0, T(0.25));
  std::vector<Reference<T>> references(count);
  for (size_t i = 0; i < count; ++i) {
    Box<T> box;
    const Vec3<T> corner(place(random), place(random), place(random));
    box.include(corner);
    box.include(corner + Vec3<T>(size(random), size(random), size(random)));
    references[i].set(box, static_cast<uint32_t>(i));
  }
  return references;
}

template <class T>
void expect_what_plain_code_finds(size_t count) {
  const std::vector<Reference<T>> references = random_references<T>(count);
  const BinMapping<T> mapping(bounds_of_centres<T>(references), most_bins);
  const SplitSteps<T> here = SplitSteps<T>::here();
  Bins<T> bins(most_bins), plain_bins(most_bins);
  here.fill(bins, references, mapping);
  plain_bins.add(references, mapping);
  for (int b = 0; b < most_bins; ++b) {
    EXPECT_TRUE(same_lanes(bins.bin[b].count, plain_bins.bin[b].count)) << b;
    for (int axis = 0; axis < 3; ++axis)
      EXPECT_TRUE(are_equal(bins.bin[b].box[axis], plain_bins.bin[b].box[axis])) << b << ' ' << axis;
  }
  constexpr int block_shift = 3;
  const SplitPlane<T> plane = here.cheapest(bins, most_bins, block_shift),
                      plain = PlaneSweep<T>(plain_bins, most_bins, block_shift).cheapest();
  EXPECT_EQ(plane.cost, plain.cost);
  EXPECT_EQ(plane.axis, plain.axis);
  EXPECT_EQ(plane.bin, plain.bin);
  EXPECT_EQ(plane.left_count, plain.left_count);
  EXPECT_TRUE(are_equal(plane.left, plain.left) && are_equal(plane.right, plain.right));
  std::vector<Reference<T>> sides(count), plain_sides(count);
  const auto moved = here.move(references, mapping, plane, sides.data(), sides.data() + plane.left_count);
  EXPECT_EQ(moved.left_count, partition<T>(references, mapping, plain.axis, plain.bin, plain_sides.data(),
                                           plain_sides.data() + plain.left_count));
  EXPECT_EQ(moved.left_count, plain.left_count);
  EXPECT_TRUE(are_equal(sides, plain_sides));
  const auto all = std::span<const Reference<T>>(plain_sides);
  EXPECT_TRUE(are_equal(moved.left, bounds_of_centres<T>(all.first(moved.left_count))));
  EXPECT_TRUE(are_equal(moved.right, bounds_of_centres<T>(all.subspan(moved.left_count))));
}

TEST(split_steps, find_what_plain_code_finds) {
  for (const size_t count : {2, 7, 100, 5000}) {
    expect_what_plain_code_finds<float>(count);
    expect_what_plain_code_finds<double>(count);
  }
}

/// Some without area, some thin.
TEST(split_steps, wide_faces_are_those_of_one_triangle_at_a_time) {
  std::mt19937 random(6);
  std::uniform_real_distribution<float> number(-2, 2);
  const auto point = [&] { return Vec3f(number(random), number(random), number(random)); };
  for (int i = 0; i < 200; ++i) {
    std::array<Triangle<float>, faces_at_once> triangles;
    for (auto& [a, b, c] : triangles) {
      a = point(), b = point(), c = point();
      if (i % 5 == 1) c = a;
      if (i % 5 == 2) c = a + (b - a) * 0.5f;
      if (i % 5 == 3) b = a + point() * 1e-6f;
    }
    const auto faces = wide_faces_of(triangles);
    for (size_t k = 0; k < faces_at_once; ++k) {
      const TriangleFace<float> one = faces_of<float, 1>({triangles[k]})[0];
      EXPECT_TRUE(faces[k].normal == one.normal) << i << ' ' << k;
      EXPECT_EQ(faces[k].clearance, one.clearance) << i << ' ' << k;
      EXPECT_EQ(faces[k].inset, one.inset) << i << ' ' << k;
    }
  }
}

}  // namespace
}  // namespace raysweep
