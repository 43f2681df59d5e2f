// What kernels visit on their way through a wide tree, counted where RAYSWEEP_COUNT_VISITS is set. Elsewhere
// nothing of it is compiled: it would cost what is measured.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace raysweep {

/// A node is visited when its children's boxes are compared with a ray or a packet, a block when its
/// primitives, or their boxes, are. A test is one pair of a primitive and a ray, or of a primitive and a
/// packet, whose rays all meet it then. A look is what follows where a test has found a hit: whether it
/// counts.
enum class Visited {
  ray_begun,  // alone
  ray_node,
  ray_block,
  ray_test,
  ray_look,  // of all that one ray hits in a block
  packet_begun,
  packet_missed,   // a group whose rays all miss the box around everything
  packet_refused,  // one whose rays are not regular, or where packets do not pay
  packet_box,      // a child's, compared with each ray before the packet goes on there
  packet_child,    // gone on to without that
  packet_node,
  packet_node_of_few,  // compared with two rays at most, instead of all
  packet_block,
  packet_test,
  packet_look,         // of one triangle
  packet_block_apart,  // compared with some rays
  packet_ray,          // one of them, which meets the whole block
  packet_ray_look,     // of all that it hits there
};
inline constexpr std::array visit_names{
    "ray_begun",          "ray_node",           "ray_block",      "ray_test",    "ray_look",
    "packet_begun",       "packet_missed",      "packet_refused", "packet_box",  "packet_child",
    "packet_node",        "packet_node_of_few", "packet_block",   "packet_test", "packet_look",
    "packet_block_apart", "packet_ray",         "packet_ray_look"};

#ifdef RAYSWEEP_COUNT_VISITS

inline constexpr bool counts_visits = true;

class VisitCounts {
 public:
  [[nodiscard]] uint64_t operator[](Visited what) const { return counts_[static_cast<size_t>(what)]; }
  [[nodiscard]] uint64_t& operator[](Visited what) { return counts_[static_cast<size_t>(what)]; }

  friend bool operator==(const VisitCounts&, const VisitCounts&) = default;

 private:
  std::array<uint64_t, visit_names.size()> counts_{};
};

/// What RAYSWEEP_COUNT counts with.
class VisitCounter {
 public:
  explicit VisitCounter(VisitCounts& counts) : counts_(counts) {}
  void operator()(Visited what, uint64_t count = 1) const { counts_[what] += count; }

 private:
  VisitCounts& counts_;
};

#define RAYSWEEP_COUNT(counter, ...) counter(__VA_ARGS__)

#else

inline constexpr bool counts_visits = false;

struct VisitCounts {
  [[nodiscard]] uint64_t operator[](Visited) const { return 0; }
};

struct VisitCounter {
  explicit VisitCounter(VisitCounts&) {}
};

// Not even a call of nothing: that would change how compilers allot registers.
#define RAYSWEEP_COUNT(counter, ...) static_cast<void>(0)

#endif

}  // namespace raysweep
