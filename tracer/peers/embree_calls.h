// Embree's calls by the width of their packets: for what traces, not for who asks.
#pragma once

#include <embree3/rtcore.h>

#include "tracer/math/ray.h"

namespace raysweep {

/// Embree's types and calls for packets of `width` rays.
template <unsigned width>
struct EmbreeCalls;

template <>
struct EmbreeCalls<1> {
  using Ray = RTCRay;
  using RayHit = RTCRayHit;
  static void intersect(const int*, RTCScene s, RTCIntersectContext* c, RayHit* r) { rtcIntersect1(s, c, r); }
  static void occluded(const int*, RTCScene s, RTCIntersectContext* c, Ray* r) { rtcOccluded1(s, c, r); }
};

template <>
struct EmbreeCalls<4> {
  using Ray = RTCRay4;
  using RayHit = RTCRayHit4;
  static constexpr auto intersect = rtcIntersect4;
  static constexpr auto occluded = rtcOccluded4;
};

template <>
struct EmbreeCalls<8> {
  using Ray = RTCRay8;
  using RayHit = RTCRayHit8;
  static constexpr auto intersect = rtcIntersect8;
  static constexpr auto occluded = rtcOccluded8;
};

template <>
struct EmbreeCalls<16> {
  using Ray = RTCRay16;
  using RayHit = RTCRayHit16;
  static constexpr auto intersect = rtcIntersect16;
  static constexpr auto occluded = rtcOccluded16;
};

/// Embree's rays must be within ± this (FLT_LARGE in its sources).
inline constexpr float largest_embree = 1.844e18f;

/// Whether Embree may be handed this ray: builds of it with assertions end the process for others.
[[nodiscard]] inline bool is_taken_by_embree(const Ray<float>& ray, float t_max) {
  return is_finite(ray) && max_abs(ray.origin) < largest_embree && max_abs(ray.direction) < largest_embree &&
         t_max >= 0;
}

}  // namespace raysweep
