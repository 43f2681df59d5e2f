#include "tracer/peers/embree_core.h"

#include <cstring>
#include <type_traits>

#include "tracer/peers/embree_calls.h"
#include "tracer/peers/flush_denormals.h"

namespace raysweep {

namespace {

/// The rays of one batch in packets: laid out, traced, read.
template <unsigned width, bool any_hit>
class PacketBatch {
 public:
  PacketBatch(size_t ray_count, EmbreeScratch& scratch)
      : scratch_(scratch),
        count_((ray_count + width - 1) / width),
        packets_(static_cast<Packet*>(scratch.memory.reserve(count_ * sizeof(Packet)))) {}

  /// Rays end where they meet a plane or a sphere, as `hits` tells.
  void lay_out(const RayBatch& rays, const HitBatch& hits) {
    for (size_t p = 0; p < count_; ++p) {
      Rays& ray = ray_of(packets_[p]);
      const size_t first = p * width;
      copy(&ray.org_x, &rays.origin_x[first]);
      copy(&ray.org_y, &rays.origin_y[first]);
      copy(&ray.org_z, &rays.origin_z[first]);
      copy(&ray.dir_x, &rays.direction_x[first]);
      copy(&ray.dir_y, &rays.direction_y[first]);
      copy(&ray.dir_z, &rays.direction_z[first]);
      copy(&ray.tfar, &hits.t[first]);
      switch_off(ray, first);
      std::memset(&ray.tnear, 0, lane_bytes);
      std::memset(&ray.time, 0, lane_bytes);
      std::memset(&ray.mask, 0xff, lane_bytes);
      std::memset(&ray.flags, 0, lane_bytes);
      if constexpr (!any_hit) {
        static_assert(RTC_INVALID_GEOMETRY_ID == 0xffffffff);
        std::memset(&packets_[p].hit.geomID, 0xff, lane_bytes);
        std::memset(&packets_[p].hit.instID, 0xff, lane_bytes);
      }
    }
  }

  void trace(const EmbreeScene& scene, bool coherent, double (*now)()) {
    const double begin = now();
    const FlushDenormals flush;
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = coherent ? RTC_INTERSECT_CONTEXT_FLAG_COHERENT : RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT;
    for (size_t p = 0; p < count_; ++p) {
      const int* const active = &scratch_.active[p * width];
      if (width == 1 && *active == 0) continue;
      if constexpr (any_hit) {
        EmbreeCalls<width>::occluded(active, scene.handle(), &context, &packets_[p]);
      } else {
        EmbreeCalls<width>::intersect(active, scene.handle(), &context, &packets_[p]);
      }
    }
    scratch_.seconds_inside += now() - begin;
  }

  void read(uint32_t first_triangle, size_t ray_count, HitBatch& hits) const {
    for (size_t p = 0; p < count_; ++p) {
      float t[width];
      copy(t, &ray_of(packets_[p]).tfar);
      unsigned geometry[width], triangle[width];
      if constexpr (!any_hit) {
        copy(geometry, &packets_[p].hit.geomID);
        copy(triangle, &packets_[p].hit.primID);
      }
      for (size_t lane = 0, i = p * width; lane < width && i < ray_count; ++lane, ++i) {
        if constexpr (any_hit) {  // tfar becomes −∞ where there is a hit
          if (scratch_.active[i] != 0 && t[lane] < 0) hits.id[i] = first_triangle;
        } else if (geometry[lane] != RTC_INVALID_GEOMETRY_ID && t[lane] < hits.t[i]) {
          hits.t[i] = t[lane];
          hits.id[i] = first_triangle + triangle[lane];
        }
      }
    }
  }

 private:
  using Packet =
      std::conditional_t<any_hit, typename EmbreeCalls<width>::Ray, typename EmbreeCalls<width>::RayHit>;
  using Rays = typename EmbreeCalls<width>::Ray;
  static constexpr size_t lane_bytes = width * sizeof(float);

  /// Builds of Embree with assertions look at rays that its mask switches off, too, where they split packets.
  void switch_off(Rays& rays, size_t first) const {
    auto* const ray = reinterpret_cast<RTCRayN*>(&rays);
    for (unsigned lane = 0; lane < width; ++lane) {
      if (scratch_.active[first + lane] != 0) continue;
      RTCRayN_org_x(ray, width, lane) = RTCRayN_org_y(ray, width, lane) = RTCRayN_org_z(ray, width, lane) = 0;
      RTCRayN_dir_x(ray, width, lane) = RTCRayN_dir_y(ray, width, lane) = RTCRayN_dir_z(ray, width, lane) = 0;
      RTCRayN_tfar(ray, width, lane) = 0;
    }
  }

  template <class P>
  static auto& ray_of(P& packet) {
    if constexpr (any_hit) {
      return packet;
    } else {
      return packet.ray;
    }
  }

  /// One number of each ray: arrays of a batch are padded to whole packets.
  static void copy(void* to, const void* from) { std::memcpy(to, from, lane_bytes); }

  EmbreeScratch& scratch_;
  size_t count_;
  Packet* packets_;
};

/// Planes and spheres first; what is switched off then asks Embree nothing.
template <bool any_hit>
void meet_others(const EmbreeShapes& shapes, const RayBatch& rays, HitBatch& hits, EmbreeScratch& scratch) {
  scratch.active.resize(std::max(scratch.active.size(), padded_to_lanes(rays.size)));
  for (size_t i = 0; i < rays.size; ++i) {
    const Ray<float> ray = rays.ray(i);
    // Hidden is what is met before the limit, not at it: no id stands before all.
    const Hit<float> limit{rays.t_max[i], any_hit ? 0 : no_hit_id};
    const Hit<float> nearest = shapes.nearest_other(ray, limit);
    const bool is_met = nearest.t < limit.t;
    hits.t[i] = nearest.t;
    hits.id[i] = is_met ? nearest.id : no_hit_id;
    scratch.active[i] = is_taken_by_embree(ray, nearest.t) && !(any_hit && is_met) ? -1 : 0;
  }
  for (size_t i = rays.size; i < padded_to_lanes(rays.size); ++i) scratch.active[i] = 0;
}

template <bool any_hit>
void trace(const EmbreeGeometry& geometry, EmbreePackets how, const RayBatch& rays, HitBatch& hits,
           EmbreeScratch& scratch) {
  meet_others<any_hit>(*geometry.shapes, rays, hits, scratch);
  const auto by = [&]<unsigned width>(std::integral_constant<unsigned, width>) {
    PacketBatch<width, any_hit> packets(rays.size, scratch);
    packets.lay_out(rays, hits);
    packets.trace(*geometry.triangles, how.coherent, geometry.now);
    packets.read(geometry.shapes->first_triangle(), rays.size, hits);
  };
  switch (how.width) {
    case 1:
      return by(std::integral_constant<unsigned, 1>());
    case 4:
      return by(std::integral_constant<unsigned, 4>());
    case 8:
      return by(std::integral_constant<unsigned, 8>());
    case 16:
      return by(std::integral_constant<unsigned, 16>());
    default:
      throw std::invalid_argument("Embree has packets of 1, 4, 8 and 16 rays, none of " +
                                  std::to_string(how.width));
  }
}

}  // namespace

std::optional<Hit<float>> EmbreeCore::closest(const Ray<float>& ray) const {
  RayBatch rays(1);
  rays.set(0, ray);
  HitBatch hits(1);
  EmbreeScratch scratch;
  closest(rays, hits, scratch);
  if (hits.id[0] == no_hit_id) return std::nullopt;
  return Hit<float>{hits.t[0], hits.id[0]};
}

void EmbreeCore::closest(const RayBatch& rays, HitBatch& hits, EmbreeScratch& scratch) const {
  const EmbreeModes& modes = geometry_.modes;
  trace<false>(geometry_, scratch.is_primary ? modes.primary : modes.mirrored, rays, hits, scratch);
}

void EmbreeCore::occluded(const RayBatch& rays, HitBatch& hits, EmbreeScratch& scratch) const {
  trace<true>(geometry_, geometry_.modes.shadow, rays, hits, scratch);
}

}  // namespace raysweep
