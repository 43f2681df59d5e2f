#include "experiments/peers/hits.h"

#include <gtest/gtest.h>

namespace raysweep {
namespace {

HitBatch batch(const std::vector<std::pair<float, uint32_t>>& hits) {
  HitBatch made(hits.size());
  for (size_t i = 0; i < hits.size(); ++i) {
    made.t[i] = hits[i].first;
    made.id[i] = hits[i].second;
  }
  return made;
}

TEST(hit_differences, are_counted_and_those_in_the_same_place_apart) {
  const HitBatch a = batch({{1, 7}, {1, 7}, {1, 7}, {1, 7}, {9, no_hit_id}});
  const HitBatch b = batch({{1, 7}, {1, 8}, {1.1f, 8}, {9, no_hit_id}, {1, 7}});
  const HitDifferences d = differences(a, b, 5, false);
  EXPECT_EQ(d.rays, 4u);
  EXPECT_EQ(d.same_place, 1u) << "triangles that share an edge, both hit there";
}

TEST(hit_differences, of_any_hits_are_whether_there_is_one) {
  const HitDifferences d =
      differences(batch({{1, 7}, {1, 7}, {1, no_hit_id}}), batch({{2, 0}, {1, no_hit_id}, {1, 3}}), 3, true);
  EXPECT_EQ(d.rays, 2u);
  EXPECT_EQ(d.same_place, 0u);
}

TEST(hit_differences, do_not_look_at_what_pads_a_batch) {
  HitBatch a = batch({{1, 7}});
  a.id[1] = 5;
  EXPECT_EQ(differences(a, batch({{1, 7}}), 1, false).rays, 0u);
}

}  // namespace
}  // namespace raysweep
