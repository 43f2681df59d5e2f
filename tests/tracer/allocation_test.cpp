// Tiles are rendered without asking for memory, once a workspace has been through them. A program of its own:
// it replaces what allocates.
#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <new>

#include "tests/tracer/variants.h"

namespace {

std::atomic<size_t> allocation_count{0};

void* allocated(void* memory) {
  allocation_count++;
  if (!memory) throw std::bad_alloc();
  return memory;
}

}  // namespace

void* operator new(size_t bytes) { return allocated(std::malloc(bytes)); }
void* operator new(size_t bytes, std::align_val_t alignment) {
  const auto to = static_cast<size_t>(alignment);
  return allocated(std::aligned_alloc(to, (bytes + to - 1) / to * to));
}
// Sanitizers have one of their own, which does not lead to the first: std::stable_sort asks for its buffer
// so.
void* operator new(size_t bytes, const std::nothrow_t&) noexcept {
  allocation_count++;
  return std::malloc(bytes);
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, const std::nothrow_t&) noexcept { std::free(memory); }
void operator delete(void* memory, size_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete(void* memory, size_t, std::align_val_t) noexcept { std::free(memory); }

namespace raysweep {
namespace {

/// Of a whole picture in items of one pixel, the second of two.
size_t allocations_of_a_picture(const Scene& scene, const RenderSettings& settings) {
  const auto renderer = make_renderer(scene, settings);
  const auto workspace = renderer->make_workspace();
  Film film(settings.width, settings.height);
  size_t before = 0;
  for (int frame = 0; frame < 2; ++frame) {
    before = allocation_count;
    for (int y = 0; y < settings.height; ++y)
      for (int x = 0; x < settings.width; ++x) renderer->render({x, y, 1, 1}, film, *workspace);
  }
  return allocation_count - before;
}

TEST(allocation, is_counted_here) {
  const size_t before = allocation_count;
  const Film film(1, 1);
  EXPECT_EQ(allocation_count, before + 1);
}

TEST(allocation, is_done_with_after_the_first_picture) {
  for (const char* scene : {"chair-ball", "cornell-glass"}) {
    for (const Choice& core : cores()) {
      RenderSettings settings;
      settings.width = 24;
      settings.height = 18;
      settings.subpixels = 2;
      settings.depth = 6;
      settings.core = core.name;
      EXPECT_EQ(allocations_of_a_picture(load_scene(scene, 2), settings), 0u) << scene << ' ' << core.name;
    }
  }
}

}  // namespace
}  // namespace raysweep
