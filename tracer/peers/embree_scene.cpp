#include "tracer/peers/embree_scene.h"

#include <embree3/rtcore.h>

namespace raysweep {

namespace {

/// Configuration files of the user's, which Embree would read, must not change what is
/// compared. By default Embree would rather keep to 256 bits, for the sake of the clock rate; where AVX-512
/// is asked for by name, all of it is meant.
std::string device_config(const EmbreeBuild& how) {
  std::string config = "threads=" + std::to_string(how.threads) +
                       ",start_threads=" + (how.threads > 1 ? "1" : "0") +
                       ",set_affinity=0,ignore_config_files=1,isa=" + how.isa;
  if (how.isa == "avx512") config += ",frequency_level=simd512";
  return config;
}

size_t vertex_count(const Scene& scene) {
  size_t count = 0;
  for (const Mesh& mesh : scene.meshes) count += mesh.vertices.size();
  return count;
}

size_t triangles_of(const Scene& scene) {
  size_t count = 0;
  for (const Mesh& mesh : scene.meshes) count += mesh.triangles.size();
  return count;
}

/// Copies all meshes into buffers of Embree's, one after the other.
void fill(RTCGeometry geometry, const Scene& scene) {
  constexpr size_t vertex_bytes = 3 * sizeof(float), triangle_bytes = 3 * sizeof(uint32_t);
  auto* vertex = static_cast<float*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, vertex_bytes, vertex_count(scene)));
  auto* index = static_cast<uint32_t*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, triangle_bytes, triangles_of(scene)));
  if (!vertex || !index) return;  // the device tells why
  uint32_t base = 0;
  for (const Mesh& mesh : scene.meshes) {
    for (const Vec3f& v : mesh.vertices) {
      *vertex++ = v.x;
      *vertex++ = v.y;
      *vertex++ = v.z;
    }
    for (const auto& triangle : mesh.triangles)
      for (const uint32_t corner : triangle) *index++ = base + corner;
    base += static_cast<uint32_t>(mesh.vertices.size());
  }
}

}  // namespace

std::string embree_version() { return RTC_VERSION_STRING; }

bool embree_has_assertions() { return RAYSWEEP_EMBREE_HAS_ASSERTIONS; }

std::string EmbreeBuild::name() const {
  return isa + (high_quality ? " high" : " medium") + (robust ? " robust" : "");
}

EmbreeScene::EmbreeScene(const EmbreeBuild& how)
    : how_(how), device_(rtcNewDevice(device_config(how).c_str())) {
  if (!device_) throw EmbreeError("Embree: this processor cannot run " + how.isa);
  if (how.threads == 1) rtcSetDeviceMemoryMonitorFunction(device_, count_memory, this);
}

EmbreeScene::~EmbreeScene() {
  if (scene_) rtcReleaseScene(scene_);
  rtcReleaseDevice(device_);
}

void EmbreeScene::build(const Scene& scene) {
  if (scene_) rtcReleaseScene(scene_);
  first_triangle_ = static_cast<uint32_t>(scene.planes.size() + scene.spheres.size());
  scene_ = rtcNewScene(device_);
  rtcSetSceneBuildQuality(scene_, how_.high_quality ? RTC_BUILD_QUALITY_HIGH : RTC_BUILD_QUALITY_MEDIUM);
  rtcSetSceneFlags(scene_, how_.robust ? RTC_SCENE_FLAG_ROBUST : RTC_SCENE_FLAG_NONE);
  const RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
  fill(geometry, scene);
  // Without this, a geometry's quality is medium whatever its scene's.
  rtcSetGeometryBuildQuality(geometry, how_.high_quality ? RTC_BUILD_QUALITY_HIGH : RTC_BUILD_QUALITY_MEDIUM);
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(scene_, geometry);
  rtcReleaseGeometry(geometry);  // the scene keeps it
  rtcCommitScene(scene_);
  check("building");
}

bool EmbreeScene::count_memory(void* scene, ptrdiff_t bytes, bool) {
  static_cast<EmbreeScene*>(scene)->bytes_ += bytes;
  return true;  // go on
}

void EmbreeScene::check(const char* doing) const {
  const RTCError error = rtcGetDeviceError(device_);
  if (error == RTC_ERROR_OUT_OF_MEMORY) throw std::bad_alloc();
  if (error != RTC_ERROR_NONE)
    throw EmbreeError(std::string("Embree: ") + doing + " failed with its error " + std::to_string(error));
}

}  // namespace raysweep
