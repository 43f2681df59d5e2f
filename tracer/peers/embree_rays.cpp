#include "tracer/peers/embree_rays.h"

#include <array>
#include <cstring>
#include <stdexcept>

#include "tracer/peers/embree_calls.h"
#include "tracer/peers/flush_denormals.h"

namespace raysweep {

namespace {

/// A copy of `from`, of the same size.
template <class T>
void copy(const LaneArray<T>& from, LaneArray<T>& to) {
  if (!from.empty()) std::memcpy(to.data(), from.data(), from.size() * sizeof(T));
}

template <unsigned width>
class Packets final : public EmbreeRays {
 public:
  void prepare(const RayBatch& rays, bool any_hit) override {
    size_ = rays.size;
    any_hit_ = any_hit;
    const size_t count = (size_ + width - 1) / width;
    pristine_.assign(any_hit ? 0 : count, {});
    pristine_shadow_.assign(any_hit ? count : 0, {});
    for (size_t i = 0; i < count * width; ++i) {
      // What fills the last packet up is switched off by `last_valid_`.
      set(i, rays.ray(std::min(i, size_ - 1)), rays.t_max[std::min(i, size_ - 1)]);
    }
    for (unsigned lane = 0; lane < width; ++lane)
      last_valid_[lane] = count == 0 || (count - 1) * width + lane < size_ ? -1 : 0;
    packets_ = pristine_;
    shadow_ = pristine_shadow_;
  }

  void reset() override {
    copy(pristine_, packets_);
    copy(pristine_shadow_, shadow_);
  }

  void trace(const EmbreeScene& scene, bool coherent) override {
    const FlushDenormals flush;
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = coherent ? RTC_INTERSECT_CONTEXT_FLAG_COHERENT : RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT;
    trace_all(packets_, EmbreeCalls<width>::intersect, scene.handle(), context);
    trace_all(shadow_, EmbreeCalls<width>::occluded, scene.handle(), context);
  }

  [[nodiscard]] HitBatch hits(const EmbreeScene& scene) const override {
    HitBatch hits(size_);
    for (size_t i = 0; i < size_; ++i) {
      const auto lane = static_cast<unsigned>(i % width);
      RTCRayN* const ray = any_hit_ ? ray_of(const_cast<Shadow&>(shadow_[i / width]))
                                    : ray_of(const_cast<Packet&>(packets_[i / width]));
      hits.t[i] = RTCRayN_tfar(ray, width, lane);
      if (any_hit_) {  // tfar becomes −∞ where there is a hit
        if (hits.t[i] < 0) hits.id[i] = scene.first_triangle();
        continue;
      }
      RTCHitN* const hit = hit_of(const_cast<Packet&>(packets_[i / width]));
      if (RTCHitN_geomID(hit, width, lane) != RTC_INVALID_GEOMETRY_ID)
        hits.id[i] = scene.first_triangle() + RTCHitN_primID(hit, width, lane);
    }
    return hits;
  }

 private:
  using Packet = typename EmbreeCalls<width>::RayHit;
  using Shadow = typename EmbreeCalls<width>::Ray;

  static RTCRayN* ray_of(Shadow& rays) { return reinterpret_cast<RTCRayN*>(&rays); }
  static RTCRayN* ray_of(Packet& rays) { return reinterpret_cast<RTCRayN*>(&rays.ray); }
  static RTCHitN* hit_of(Packet& rays) { return reinterpret_cast<RTCHitN*>(&rays.hit); }

  void set(size_t i, const Ray<float>& from, float t_max) {
    if (!is_taken_by_embree(from, t_max))
      throw std::invalid_argument("ray " + std::to_string(i) + " is none that Embree takes");
    const auto lane = static_cast<unsigned>(i % width);
    RTCRayN* const ray = any_hit_ ? ray_of(pristine_shadow_[i / width]) : ray_of(pristine_[i / width]);
    RTCRayN_org_x(ray, width, lane) = from.origin.x;
    RTCRayN_org_y(ray, width, lane) = from.origin.y;
    RTCRayN_org_z(ray, width, lane) = from.origin.z;
    RTCRayN_dir_x(ray, width, lane) = from.direction.x;
    RTCRayN_dir_y(ray, width, lane) = from.direction.y;
    RTCRayN_dir_z(ray, width, lane) = from.direction.z;
    RTCRayN_tnear(ray, width, lane) = 0;
    RTCRayN_time(ray, width, lane) = 0;
    RTCRayN_tfar(ray, width, lane) = t_max;
    RTCRayN_mask(ray, width, lane) = ~0u;
    RTCRayN_id(ray, width, lane) = static_cast<unsigned>(i);
    RTCRayN_flags(ray, width, lane) = 0;
    if (any_hit_) return;
    RTCHitN* const hit = hit_of(pristine_[i / width]);
    RTCHitN_primID(hit, width, lane) = RTC_INVALID_GEOMETRY_ID;
    RTCHitN_geomID(hit, width, lane) = RTC_INVALID_GEOMETRY_ID;
    RTCHitN_instID(hit, width, lane, 0) = RTC_INVALID_GEOMETRY_ID;
  }

  template <class Rays, class Call>
  void trace_all(Rays& rays, Call call, RTCScene scene, RTCIntersectContext& context) {
    if (rays.empty()) return;
    for (size_t p = 0; p + 1 < rays.size(); ++p) call(all_valid_.data(), scene, &context, &rays[p]);
    call(last_valid_.data(), scene, &context, &rays.back());
  }

  static constexpr std::array<int, width> filled(int value) {
    std::array<int, width> lanes{};
    lanes.fill(value);
    return lanes;
  }

  size_t size_ = 0;
  bool any_hit_ = false;
  LaneArray<Packet> pristine_, packets_;        // for nearest hits
  LaneArray<Shadow> pristine_shadow_, shadow_;  // for any hits
  // Embree's masks of active rays: −1 or 0 a lane, aligned like its packets.
  alignas(64) std::array<int, width> all_valid_ = filled(-1);
  alignas(64) std::array<int, width> last_valid_ = filled(-1);
};

}  // namespace

std::unique_ptr<EmbreeRays> make_embree_rays(int width) {
  switch (width) {
    case 1:
      return std::make_unique<Packets<1>>();
    case 4:
      return std::make_unique<Packets<4>>();
    case 8:
      return std::make_unique<Packets<8>>();
    case 16:
      return std::make_unique<Packets<16>>();
    default:
      throw std::invalid_argument("Embree has packets of 1, 4, 8 and 16 rays, none of " +
                                  std::to_string(width));
  }
}

}  // namespace raysweep
