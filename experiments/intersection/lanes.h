// Many numbers that go through a formula together. Compiled for the instruction set of its file: only modules
// read this, since functions of templates would otherwise be shared with files for other processors.
#pragma once

#include <hwy/highway.h>

#include <array>
#include <concepts>
#include <cstddef>
#include <utility>

#include "tracer/intersect/value.h"

namespace raysweep {

namespace hn = hwy::HWY_NAMESPACE;

/// Whether the axis that a projection drops is one for all lanes, since they belong to one triangle or one
/// ray whose axis it is, or another for each.
enum class Axes { shared, per_lane };

/// `width` numbers of type `T`, as vectors of as many of them as the instruction set has, at most.
template <class T, int width_, Axes axes>
class Lanes {
 public:
  using Number = T;
  static constexpr int width = width_;

  using Tag = hn::CappedTag<T, width>;
  using Vector = hn::Vec<Tag>;
  static constexpr size_t part_width = hn::MaxLanes(Tag());
  static constexpr size_t part_count = width / part_width;

  /// In each vector the lanes where a comparison holds.
  struct Mask {
    std::array<hn::Mask<Tag>, part_count> parts;
  };

  Lanes() = default;
  // Vector by vector: a struct of many lanes that is copied whole goes through the stack, by GCC 12.
  Lanes(const Lanes& other) { *this = other; }
  // NOLINTNEXTLINE(bugprone-unhandled-self-assignment): what is assigned to itself stays as it is
  Lanes& operator=(const Lanes& other) {
    for (size_t i = 0; i < part_count; ++i) parts_[i] = other.parts_[i];
    return *this;
  }
  /// The same number in all lanes.
  template <class Number>
  requires std::is_arithmetic_v<Number>
  explicit Lanes(Number x) {
    for (Vector& part : parts_) part = hn::Set(Tag(), static_cast<T>(x));
  }

  [[nodiscard]] static Lanes load(const T* numbers) {
    return each([&](size_t i) { return hn::LoadU(Tag(), numbers + i * part_width); });
  }
  /// numbers[0], numbers[stride], …
  [[nodiscard]] static Lanes gather(const T* numbers, size_t stride) {
    using Index = hn::RebindToSigned<Tag>;
    std::array<hn::TFromD<Index>, part_width> steps;
    for (size_t i = 0; i < part_width; ++i) steps[i] = static_cast<hn::TFromD<Index>>(i * stride);
    const auto index = hn::LoadU(Index(), steps.data());
    return each([&](size_t i) { return hn::GatherIndex(Tag(), numbers + i * part_width * stride, index); });
  }
  void store(T* numbers) const {
    for (size_t i = 0; i < part_count; ++i) hn::StoreU(parts_[i], Tag(), numbers + i * part_width);
  }

  friend Lanes operator+(const Lanes& a, const Lanes& b) {
    return each([&](size_t i) { return hn::Add(a.parts_[i], b.parts_[i]); });
  }
  friend Lanes operator-(const Lanes& a, const Lanes& b) {
    return each([&](size_t i) { return hn::Sub(a.parts_[i], b.parts_[i]); });
  }
  friend Lanes operator*(const Lanes& a, const Lanes& b) {
    return each([&](size_t i) { return hn::Mul(a.parts_[i], b.parts_[i]); });
  }
  friend Lanes operator/(const Lanes& a, const Lanes& b) {
    return each([&](size_t i) { return hn::Div(a.parts_[i], b.parts_[i]); });
  }
  friend Lanes operator-(const Lanes& a) {
    return each([&](size_t i) { return hn::Neg(a.parts_[i]); });
  }
  friend Mask operator<(const Lanes& a, const Lanes& b) {
    return mask([&](size_t i) { return hn::Lt(a.parts_[i], b.parts_[i]); });
  }
  friend Mask operator<=(const Lanes& a, const Lanes& b) {
    return mask([&](size_t i) { return hn::Le(a.parts_[i], b.parts_[i]); });
  }
  friend Mask operator>(const Lanes& a, const Lanes& b) { return b < a; }
  friend Mask operator>=(const Lanes& a, const Lanes& b) { return b <= a; }
  /// Not operator==, which vectors of lanes would then be thought to have, too.
  friend Mask equal(const Lanes& a, const Lanes& b) {
    return mask([&](size_t i) { return hn::Eq(a.parts_[i], b.parts_[i]); });
  }

  friend Mask both(const Mask& a, const Mask& b) {
    return mask([&](size_t i) { return hn::And(a.parts[i], b.parts[i]); });
  }
  friend Mask negation(const Mask& m) {
    return mask([&](size_t i) { return hn::Not(m.parts[i]); });
  }
  friend bool none(const Mask& m) {
    auto any = m.parts[0];
    for (size_t i = 1; i < part_count; ++i) any = hn::Or(any, m.parts[i]);
    return hn::AllFalse(Tag(), any);
  }
  /// `yes` where `m` holds, else `no`.
  friend Lanes select(const Mask& m, const Lanes& yes, const Lanes& no) {
    return each([&](size_t i) { return hn::IfThenElse(m.parts[i], yes.parts_[i], no.parts_[i]); });
  }
  friend Lanes greatest(const Lanes& /*type*/) { return Lanes(std::numeric_limits<T>::max()); }
  friend Lanes not_given(const Lanes& /*type*/) { return Lanes(std::numeric_limits<T>::quiet_NaN()); }

  /// As for one number, by the instruction of the lanes' own set: AVX-512's is nearer than that of one float.
  friend Lanes approximate_reciprocal(const Lanes& x) requires std::same_as<T, float> {
    const Lanes y = each([&](size_t i) { return hn::ApproximateReciprocal(x.parts_[i]); });
#if HWY_ARCH_ARM
    return y + y - x * (y * y);
#else
    return y;
#endif
  }

  /// The first `count` lanes.
  [[nodiscard]] static Mask first(size_t count) {
    return mask([&](size_t i) {
      return hn::FirstN(Tag(), count > i * part_width ? count - i * part_width : size_t{0});
    });
  }
  [[nodiscard]] static size_t count(const Mask& m) {
    size_t sum = 0;
    for (const auto& part : m.parts) sum += hn::CountTrue(Tag(), part);
    return sum;
  }
  [[nodiscard]] T front() const { return hn::GetLane(parts_[0]); }

 private:
  template <class Make>
  static Lanes each(const Make& make) {
    Lanes result;
    [&]<size_t... i>(std::index_sequence<i...>) { ((result.parts_[i] = make(i)), ...); }
    (std::make_index_sequence<part_count>());
    return result;
  }
  template <class Make>
  static Mask mask(const Make& make) {
    Mask result;
    [&]<size_t... i>(std::index_sequence<i...>) { ((result.parts[i] = make(i)), ...); }
    (std::make_index_sequence<part_count>());
    return result;
  }

  Vector parts_[part_count];
};

/// The dropped axis of each lane's triangle, as a number.
template <class T, int width>
struct LaneAxes {
  Lanes<T, width, Axes::per_lane> number;
};

/// As for one number: u, v = y, z or x, z or x, y.
template <class T, int width>
[[nodiscard]] Projected<Lanes<T, width, Axes::per_lane>> project(
    const Vec3<Lanes<T, width, Axes::per_lane>>& a, const LaneAxes<T, width>& axis) {
  using V = Lanes<T, width, Axes::per_lane>;
  const auto is_x = equal(axis.number, V(0)), is_z = equal(axis.number, V(2));
  return {select(is_x, a.y, a.x), select(is_z, a.y, a.z), select(is_x, a.x, select(is_z, a.z, a.y))};
}

template <class T, int width>
struct AxisOf<Lanes<T, width, Axes::per_lane>> {
  using Type = LaneAxes<T, width>;
};

template <class T, int width, Axes axes>
[[nodiscard]] Lanes<T, width, axes> absolute(const Lanes<T, width, axes>& x) {
  using V = Lanes<T, width, axes>;
  return select(x < V(0), -x, x);
}

/// The axis of each lane along which `a` is longest; of equal ones the last.
template <class T, int width>
[[nodiscard]] LaneAxes<T, width> dominant_axis(const Vec3<Lanes<T, width, Axes::per_lane>>& a) {
  using V = Lanes<T, width, Axes::per_lane>;
  const V x = absolute(a.x), y = absolute(a.y), z = absolute(a.z);
  return {select(both(x > y, x > z), V(0), select(y > z, V(1), V(2)))};
}
/// The same where all lanes hold one vector.
template <class T, int width>
[[nodiscard]] int dominant_axis(const Vec3<Lanes<T, width, Axes::shared>>& a) {
  return dominant_axis(Vec3<T>(a.x.front(), a.y.front(), a.z.front()));
}

}  // namespace raysweep
