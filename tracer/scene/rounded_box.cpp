#include "tracer/scene/rounded_box.h"

#include <array>
#include <numbers>

namespace raysweep {

namespace {

/// Points of the surface by whole-numbered places on a cube, so that faces that share an edge share its
/// points bit for bit.
class Lattice {
 public:
  explicit Lattice(const RoundedBox& box) : box_(box), size_(2 * box.arc + box.flat) {}

  [[nodiscard]] int size() const { return size_; }

  [[nodiscard]] Vec3d point(const std::array<int, 3>& at) const {
    const Vec3d r(box_.radius, box_.radius, box_.radius);
    const Vec3d outer(place(at[0], box_.lower.x, box_.upper.x), place(at[1], box_.lower.y, box_.upper.y),
                      place(at[2], box_.lower.z, box_.upper.z));
    const Vec3d inner = max(box_.lower + r, min(box_.upper - r, outer));
    const Vec3d normal = normalize(outer - inner);
    const Vec3d p = inner + normal * box_.radius;
    return box_.dent ? p + normal * box_.dent(p) : p;
  }

 private:
  /// Cells of equal angle around the edges, of equal width between them.
  [[nodiscard]] double place(int i, double low, double high) const {
    const double inner_low = low + box_.radius, inner_high = high - box_.radius;
    const auto reach = [&](int cells) {
      return box_.radius * std::tan(std::numbers::pi / 4 * cells / box_.arc);
    };
    if (i < box_.arc) return inner_low - reach(box_.arc - i);
    if (i > size_ - box_.arc) return inner_high + reach(i - (size_ - box_.arc));
    return inner_low + (inner_high - inner_low) * (i - box_.arc) / box_.flat;
  }

  const RoundedBox& box_;
  int size_;
};

}  // namespace

void append_rounded_box(Mesh& mesh, const RoundedBox& box) {
  const Lattice lattice(box);
  const int n = lattice.size();
  for (size_t axis = 0; axis < 3; ++axis) {
    for (const bool upper : {false, true}) {
      const auto first = static_cast<uint32_t>(mesh.vertices.size());
      for (int j = 0; j <= n; ++j) {
        for (int i = 0; i <= n; ++i) {
          std::array<int, 3> at{};
          at[axis] = upper ? n : 0;
          at[(axis + 1) % 3] = i;
          at[(axis + 2) % 3] = j;
          mesh.vertices.emplace_back(lattice.point(at));
        }
      }
      const auto stride = static_cast<uint32_t>(n + 1);
      for (uint32_t j = 0; j < static_cast<uint32_t>(n); ++j) {
        for (uint32_t i = 0; i < static_cast<uint32_t>(n); ++i) {
          // The i and j axes and the face's axis form a right-handed frame: seen from the upper side i → j
          // turns left.
          uint32_t a = first + j * stride + i, b = a + 1, c = a + stride + 1, d = a + stride;
          if (!upper) std::swap(b, d);
          mesh.triangles.push_back({a, b, c});
          mesh.triangles.push_back({a, c, d});
        }
      }
    }
  }
}

}  // namespace raysweep
