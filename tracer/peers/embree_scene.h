// The triangles of a scene in Embree's hands.
#pragma once

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>

#include "tracer/scene/scene.h"

struct RTCDeviceTy;
struct RTCSceneTy;

namespace raysweep {

/// What Embree builds for, and how well.
struct EmbreeBuild {
  std::string isa = "avx2";   // or "avx512"
  bool high_quality = false;  // with spatial splits (RTC_BUILD_QUALITY_HIGH); else medium, Embree's default
  bool robust = false;        // RTC_SCENE_FLAG_ROBUST: no misses at edges, slower
  int threads = 1;            // that build

  /// "avx2 medium", "avx512 high robust"
  [[nodiscard]] std::string name() const;
};

/// "3.13.5"
[[nodiscard]] std::string embree_version();

/// Whether Embree was built with assertions, which cost time in its inner loops: Debian's package is.
[[nodiscard]] bool embree_has_assertions();

/// What Embree says against a request, as a sentence.
struct EmbreeError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A device and a scene of its own, so that its memory is counted apart. Any number of threads may trace.
class EmbreeScene {
 public:
  /// Makes the device only. Throws EmbreeError where the processor has not got these instructions.
  explicit EmbreeScene(const EmbreeBuild& how);
  ~EmbreeScene();
  EmbreeScene(const EmbreeScene&) = delete;
  EmbreeScene& operator=(const EmbreeScene&) = delete;

  /// Takes the triangles of all meshes over, in their order, as one geometry, and builds its hierarchy.
  /// Planes and spheres are left out, but keep their ids (see Primitives).
  void build(const Scene& scene);

  [[nodiscard]] RTCSceneTy* handle() const { return scene_; }
  /// Which of our ids Embree's first triangle has.
  [[nodiscard]] uint32_t first_triangle() const { return first_triangle_; }
  /// What Embree holds, its copy of the vertices included; 0 where several threads build: nobody counts.
  [[nodiscard]] size_t bytes() const { return static_cast<size_t>(bytes_); }

 private:
  static bool count_memory(void* scene, ptrdiff_t bytes, bool after);
  void check(const char* doing) const;

  EmbreeBuild how_;
  RTCDeviceTy* device_;
  RTCSceneTy* scene_ = nullptr;
  uint32_t first_triangle_ = 0;
  ptrdiff_t bytes_ = 0;  // a plain sum: counted only where the device has one thread
};

}  // namespace raysweep
