// Both ways to keep triangles tell the same of them.
#include <gtest/gtest.h>

#include "tests/tracer/shared_work.h"
#include "tracer/accel/primitives.h"
#include "tracer/intersect/moller_trumbore.h"
#include "tracer/scene/scenes.h"

namespace raysweep {
namespace {

template <class T>
using Compact = Primitives<T, MollerTrumbore>;
template <class T>
using AtHand = Primitives<T, MollerTrumbore, TrianglesAtHand<T>>;

template <class T>
void expect_the_same_shape(const TriangleShape<T>& a, const TriangleShape<T>& b) {
  EXPECT_EQ(a.corners.a, b.corners.a);
  EXPECT_EQ(a.corners.b, b.corners.b);
  EXPECT_EQ(a.corners.c, b.corners.c);
  EXPECT_EQ(a.normal, b.normal);
  EXPECT_EQ(a.clearance, b.clearance);
  EXPECT_EQ(a.inset, b.inset);
}

template <class T>
void expect_the_same(const Compact<T>& compact, const AtHand<T>& at_hand) {
  ASSERT_EQ(compact.count(), at_hand.count());
  ASSERT_EQ(compact.first_triangle(), at_hand.first_triangle());
  for (uint32_t id = compact.first_sphere(); id < compact.count() && !testing::Test::HasFailure(); ++id) {
    SCOPED_TRACE(id);
    EXPECT_EQ(compact.material(id), at_hand.material(id));
    EXPECT_EQ(compact.box(id).lower(), at_hand.box(id).lower());
    EXPECT_EQ(compact.box(id).upper(), at_hand.box(id).upper());
    if (id >= compact.first_triangle())
      expect_the_same_shape<T>(compact.triangle_shape(id), at_hand.triangle_shape(id));
  }
}

TEST(triangles, are_the_same_however_they_are_kept_and_whoever_shares_the_work) {
  for (const char* name : {"studio", "pebble"}) {  // many meshes; one in many pieces
    SCOPED_TRACE(name);
    const Scene scene = load_scene(name);
    expect_the_same<float>(Compact<float>(scene, by_threads), AtHand<float>(scene));
    expect_the_same<double>(Compact<double>(scene, backwards), AtHand<double>(scene, by_threads));
  }
}

template <class Primitives>
void expect_boxes_in_the_order_of_ids(const Primitives& primitives, const UnsetVector<Box<float>>& boxes) {
  ASSERT_EQ(boxes.size(), primitives.count() - primitives.first_sphere());
  for (uint32_t i = 0; i < boxes.size(); ++i) {
    EXPECT_EQ(boxes[i].lower(), primitives.box(primitives.first_sphere() + i).lower());
    EXPECT_EQ(boxes[i].upper(), primitives.box(primitives.first_sphere() + i).upper());
  }
}

TEST(triangles, boxes_are_in_the_order_of_ids_whenever_they_are_found) {
  const Scene scene = load_scene("studio");
  UnsetVector<Box<float>> of_compact, of_at_hand;
  const Compact<float> compact(scene, by_threads, &of_compact);
  const AtHand<float> at_hand(scene, by_threads, &of_at_hand);
  expect_boxes_in_the_order_of_ids(compact, of_compact);
  expect_boxes_in_the_order_of_ids(compact, compact.boxes());
  expect_boxes_in_the_order_of_ids(at_hand, of_at_hand);
}

}  // namespace
}  // namespace raysweep
