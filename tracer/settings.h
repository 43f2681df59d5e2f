// How a picture is to be computed: everything but the scene. Names are the ones of command line, configs and
// records.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace raysweep {

struct RenderSettings {
  int width = 800, height = 600;  // pixels
  int subpixels = 1;              // samples a pixel
  std::string pattern = "grid";
  int depth = 4;  // primary hits are depth 1, each bounce adds one
  // No channel of a pixel may lose more than this (film units) by ending paths early; 0 ends none.
  double pixel_tolerance = 0;
  int branches = 1024;  // rays a sample may trace where hits send out two: all, up to depth 10
  std::string accel = "sah";
  int leaf = 4;  // primitives a leaf holds at most
  std::string core = "scalar";
  std::string precision = "float";
  std::string method = "moller_trumbore";
  std::string isa = "best";  // instruction set of the core "wide": one of isas(); "best" is the best here
};

/// Bounds of the settings' numbers, both included.
struct Range {
  int low, high;
  [[nodiscard]] bool contains(long long v) const { return v >= low && v <= high; }
};
inline constexpr Range width_range{1, 32768}, height_range{1, 32768}, subpixels_range{1, 65536},
    depth_range{1, 1024}, branches_range{1, 1 << 20}, leaf_range{1, 1 << 24}, lights_range{0, 64};

/// A published combination of picture size and effort (Morozov 2011, 5.4).
struct Mode {
  std::string_view name;
  int width, height, subpixels, depth, lights;
};

/// low, middle, hard, very_hard.
[[nodiscard]] std::span<const Mode> modes();

/// A name that can be chosen, with one line about it.
struct Choice {
  std::string_view name, summary;
};

[[nodiscard]] std::span<const Choice> cores();
[[nodiscard]] std::span<const Choice> accels();
[[nodiscard]] std::span<const Choice> precisions();
[[nodiscard]] std::span<const Choice> patterns();
[[nodiscard]] std::span<const Choice> methods();

/// Instruction sets that this program has, best first, whether or not this machine has them: runs_here().
[[nodiscard]] std::span<const Choice> isas();

}  // namespace raysweep
