// The picture as it is computed: linear float colours, row by row.
#pragma once

#include <algorithm>
#include <cstddef>
#include <new>
#include <span>
#include <string>
#include <vector>

#include "tracer/math/vec3.h"

namespace raysweep {

/// The hit id of a pixel whose centre sees no primitive.
inline constexpr uint32_t no_hit_id = 0xffffffff;

/// Memory that begins with a cache line.
template <class T>
struct CacheLineAllocator {
  using value_type = T;
  static constexpr std::align_val_t alignment{64};
  CacheLineAllocator() = default;
  template <class U>
  explicit CacheLineAllocator(const CacheLineAllocator<U>&) {}
  T* allocate(size_t n) { return static_cast<T*>(::operator new(n * sizeof(T), alignment)); }
  void deallocate(T* memory, size_t) { ::operator delete(memory, alignment); }
  friend bool operator==(const CacheLineAllocator&, const CacheLineAllocator&) { return true; }
};

/// Its first pixel begins a cache line, so that tiles of 16 pixels' width share none where rows are a
/// multiple of 16 pixels.
class Film {
 public:
  Film(int width, int height)
      : width_(width), height_(height), pixels_(static_cast<size_t>(width) * static_cast<size_t>(height)) {}

  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }

  /// Row `y` counts from the top; writing different pixels from different threads is safe.
  [[nodiscard]] Vec3f& at(int x, int y) { return pixels_[index(x, y)]; }
  [[nodiscard]] const Vec3f& at(int x, int y) const { return pixels_[index(x, y)]; }
  [[nodiscard]] std::span<const Vec3f> pixels() const& { return pixels_; }
  std::span<const Vec3f> pixels() && = delete;  // they would not outlive their film
  void fill(const Vec3f& colour) { std::ranges::fill(pixels_, colour); }

  /// 32 hexadecimal digits over the floats in row order, before any quantising (XXH3, 128 bits).
  [[nodiscard]] std::string hash() const;

 private:
  [[nodiscard]] size_t index(int x, int y) const {
    return static_cast<size_t>(y) * static_cast<size_t>(width_) + static_cast<size_t>(x);
  }

  int width_, height_;
  std::vector<Vec3f, CacheLineAllocator<Vec3f>> pixels_;
};

/// A linear colour as 8-bit sRGB (IEC 61966-2-1), clamped to 0…1; NaN gives 0.
[[nodiscard]] unsigned char to_srgb_byte(float linear);

/// The encoder counts bytes in 32 bits.
inline constexpr size_t max_png_pixels = (size_t{1} << 31) / 4;

/// Writes 8-bit sRGB (IEC 61966-2-1): the film is linear, colours are clamped to 0…1. The file appears whole
/// or not at all. Throws std::runtime_error with a sentence when it cannot be written.
void write_png(const Film& film, const std::string& path);

}  // namespace raysweep
