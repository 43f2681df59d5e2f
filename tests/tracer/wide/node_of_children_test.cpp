// Nodes' planes lie further out than children's boxes, by so much that kernels may round.
#include "tracer/wide/node_of_children.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace raysweep {
namespace {

constexpr float u = unit_roundoff<float>;

TEST(widened, planes_lie_about_four_roundings_further_out) {
  for (const float plane : {1.0f, -1.0f, 1.5f, -0x1.fffffep20f, 0x1p-40f, 0x1p60f}) {
    Box<float> box;
    box.include(Vec3f(plane, plane, plane));
    const Box<float> wide = widened(box);
    for (int axis = 0; axis < 3; ++axis) {
      for (const float by : {plane - wide.lower()[axis], wide.upper()[axis] - plane}) {
        EXPECT_GE(by, 3 * u * std::abs(plane)) << plane;
        EXPECT_LE(by, 5 * u * std::abs(plane) + 0x1p-84f) << plane;
      }
    }
  }
}

TEST(widened, planes_at_0_move_and_empty_boxes_stay) {
  Box<float> flat;
  flat.include(Vec3f(0, 0, 0));
  EXPECT_LT(widened(flat).lower().x, 0);
  EXPECT_GT(widened(flat).upper().z, 0);
  const Box<float> empty = widened(Box<float>());
  EXPECT_EQ(empty.lower().x, Box<float>::inf);
  EXPECT_EQ(empty.upper().x, -Box<float>::inf);
}

/// Boxes and rays made to be hard to tell: flat boxes, rays from their planes or a few units in the last
/// place beside them, towards their corners and edges, or hardly along an axis.
class HardCases {
 public:
  explicit HardCases(unsigned seed) : random_(seed) {}

  [[nodiscard]] Box<float> box() {
    Box<float> box;
    const float scale = std::ldexp(1.0f, static_cast<int>(random_() % 60) - 30);
    const Vec3f corner = Vec3f(number(), number(), number()) * scale;
    box.include(corner);
    const auto size = [&] {
      return random_() % 3 == 0 ? 0.0f : (1 + number()) * scale * (coin() ? 1 : 0x1p-10f);
    };
    box.include(corner + Vec3f(size(), size(), size()));
    return box;
  }

  [[nodiscard]] Ray<float> ray(const Box<float>& box) {
    const float size = std::max(max_abs(box.lower()), max_abs(box.upper()));
    Vec3f origin, direction;
    for (float* x : {&origin.x, &origin.y, &origin.z}) {
      const auto axis = static_cast<int>(x - &origin.x);
      const float plane = box.bounds[random_() % 2][axis];
      *x = coin() ? beside(plane) : plane + number() * size * (coin() ? 1 : 100);
    }
    const Vec3f target = (box.lower() + box.upper()) * 0.5f;
    for (float* x : {&direction.x, &direction.y, &direction.z}) {
      const auto axis = static_cast<int>(x - &direction.x);
      const float to = random_() % 4 == 0 ? target[axis] : box.bounds[random_() % 2][axis];
      *x = beside(to) - origin[axis];
      if (random_() % 8 == 0) *x = std::copysign(size * 0x1p-24f * (1 + number()), number());
      if (!(std::abs(*x) >= 0x1p-60f)) *x = std::copysign(0x1p-60f, number());
    }
    return {origin, direction};
  }

 private:
  bool coin() { return random_() % 2 == 0; }
  float number() { return std::uniform_real_distribution<float>(-1, 1)(random_); }
  float beside(float x) {
    for (auto ulps = random_() % 4; ulps > 0; --ulps) x = std::nextafter(x, coin() ? -1e30f : 1e30f);
    return x;
  }

  std::mt19937 random_;
};

/// Whether a ray meets a box as kernels ask it, with their operations.
bool meets(const Box<float>& box, const SlabRay<float>& ray, float limit, bool is_fused) {
  float enter = 0, leave = std::numeric_limits<float>::infinity();
  for (int axis = 0; axis < 3; ++axis) {
    const float by = ray.reciprocal[axis], from = -(ray.origin[axis] * by);
    const auto at = [&](float plane) { return is_fused ? std::fma(plane, by, from) : plane * by + from; };
    const bool falls = std::signbit(by);
    enter = std::max(enter, at(box.bounds[falls ? 1 : 0][axis]));
    leave = std::min(leave, at(box.bounds[falls ? 0 : 1][axis]));
  }
  return enter <= std::min(leave, limit) * (1 + 0x1p-19f);
}

TEST(widened, kernels_lose_no_box_that_slab_keeps) {
  HardCases cases(7);
  size_t kept = 0, lost_unless_widened = 0;
  for (int i = 0; i < 400'000; ++i) {
    const Box<float> box = cases.box();
    const SlabRay<float> ray(cases.ray(box));
    const Interval<float> inside = slab(box, ray);
    if (inside.empty()) continue;
    ++kept;
    for (const bool is_fused : {false, true}) {
      for (const float limit : {std::numeric_limits<float>::infinity(), inside.enter})
        ASSERT_TRUE(meets(widened(box), ray, limit, is_fused)) << i << (is_fused ? " fused" : "");
      lost_unless_widened += meets(box, ray, inside.enter, is_fused) ? 0 : 1;
    }
  }
  EXPECT_GT(kept, 40'000u);
  EXPECT_GT(lost_unless_widened, 100u) << "these are not hard enough to tell";
}

}  // namespace
}  // namespace raysweep
