// Where packets go on, and how.
#if defined(RAYSWEEP_WIDE_VISIT_CHOICE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYSWEEP_WIDE_VISIT_CHOICE_INL_H_
#undef RAYSWEEP_WIDE_VISIT_CHOICE_INL_H_
#else
#define RAYSWEEP_WIDE_VISIT_CHOICE_INL_H_
#endif

#include <array>

#include "tracer/wide/group_choice.h"
#include "tracer/wide/packet_lists-inl.h"

HWY_BEFORE_NAMESPACE();
namespace raysweep {
namespace HWY_NAMESPACE {

/// What a packet goes on to: a child of a node, by the node's index times `lane_count` plus the child's
/// number, with `leaf_bit` set where that is a leaf.
struct ChildPlace {
  HWY_INLINE explicit ChildPlace(uint32_t place)
      : node((place & ~leaf_bit) / lane_count), lane(place % lane_count) {}
  /// Those of all children.
  HWY_INLINE static WordLanes of_all(uint32_t node, WordLanes children) {
    return hn::Or(hn::And(children, hn::Set(Words(), leaf_bit)), count_from(node * lane_count));
  }

  size_t node, lane;
};

/// What a packet needs next, and about what that takes.
struct VisitChoice {
  uint32_t kind, cost;
};

/// Where boxes are not tested: for the highest bit of a child, the next one set at a stack's end.
inline constexpr VisitChoice untested_visits[4] = {{PacketLists::node_of_many, StepCosts::node},
                                                   {PacketLists::leaf_of_many, StepCosts::leaf_together},
                                                   {PacketLists::ended, 0},
                                                   {PacketLists::ended, 0}};

/// Where they are: for a child's two highest bits, the next one set at a stack's end, and the number of rays
/// that meet its box.
inline constexpr auto tested_visits = [] {
  // Where leaves are visited by all rays or by each: about where it costs the same.
  constexpr size_t few = 2, many = 7;
  std::array<std::array<VisitChoice, packet_size + 1>, 8> choices{};
  for (size_t bits = 4; bits < 8; ++bits) choices[bits].fill({PacketLists::ended, 0});
  for (size_t bits = 0; bits < 4; ++bits) {
    const bool is_leaf = bits >= 2, is_spheres = bits == 3;
    choices[bits][0] = {PacketLists::popped, StepCosts::box};
    for (size_t rays = 1; rays <= packet_size; ++rays) {
      VisitChoice& choice = choices[bits][rays];
      if (!is_leaf && rays <= few)
        choice = {PacketLists::node_of_few, StepCosts::box + StepCosts::node_of_few};
      if (!is_leaf && rays > few) choice = {PacketLists::node_of_many, StepCosts::box + StepCosts::node};
      if (is_leaf && (rays >= many || is_spheres))
        choice = {PacketLists::leaf_of_many, StepCosts::box + StepCosts::leaf_together};
      if (is_leaf && rays < many && !is_spheres)
        choice = {PacketLists::leaf_of_few, StepCosts::box + StepCosts::leaf_apart +
                                                static_cast<uint32_t>(rays) * StepCosts::ray_apart};
    }
  }
  return choices;
}();

}  // namespace HWY_NAMESPACE
}  // namespace raysweep
HWY_AFTER_NAMESPACE();

#endif
