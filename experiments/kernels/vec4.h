// Four floats in as many ways: what arithmetic on them costs is the question of M11 (Morozov 2011), table 2.
#pragma once

#include <array>
#include <valarray>

namespace raysweep {

using FourFloats = std::array<float, 4>;

/// The expression that all of them evaluate, of four operations.
template <class V>
[[nodiscard]] constexpr auto expression(const V& a, const V& b, const V& c, const V& d, const V& e) {
  return (a + b) * c - d * e;
}

/// As anyone writes it first. Compilers may find the vector in it.
struct StructVec4 {
  float x, y, z, w;

  friend StructVec4 operator+(const StructVec4& a, const StructVec4& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z, a.w + b.w};
  }
  friend StructVec4 operator-(const StructVec4& a, const StructVec4& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z, a.w - b.w};
  }
  friend StructVec4 operator*(const StructVec4& a, const StructVec4& b) {
    return {a.x * b.x, a.y * b.y, a.z * b.z, a.w * b.w};
  }
};

/// A vec4 made of std::valarray whose operators hand out vec4: each result has memory of its own.
struct ValarrayVec4 {
  std::valarray<float> lanes;

  friend ValarrayVec4 operator+(const ValarrayVec4& a, const ValarrayVec4& b) { return {a.lanes + b.lanes}; }
  friend ValarrayVec4 operator-(const ValarrayVec4& a, const ValarrayVec4& b) { return {a.lanes - b.lanes}; }
  friend ValarrayVec4 operator*(const ValarrayVec4& a, const ValarrayVec4& b) { return {a.lanes * b.lanes}; }
};

// Expression templates over the compiler's vectors, which are SSE's on x86: an operator computes nothing, its
// type says what is to be done, and assignment does it lane-parallel at once (Veldhuizen 1995, "Expression
// Templates").

using PackedFloats [[gnu::vector_size(16)]] = float;

template <class E>
struct Expression {
  [[nodiscard]] const E& self() const { return static_cast<const E&>(*this); }
};

struct Plus {
  static PackedFloats of(PackedFloats a, PackedFloats b) { return a + b; }
};
struct Minus {
  static PackedFloats of(PackedFloats a, PackedFloats b) { return a - b; }
};
struct Times {
  static PackedFloats of(PackedFloats a, PackedFloats b) { return a * b; }
};

/// Operands are held as they are: they live until the end of the statement, or are nodes themselves.
template <class Left, class Operation, class Right>
class ExpressionNode : public Expression<ExpressionNode<Left, Operation, Right>> {
 public:
  ExpressionNode(const Left& left, const Right& right) : left_(left), right_(right) {}
  [[nodiscard]] PackedFloats lanes() const { return Operation::of(left_.lanes(), right_.lanes()); }

 private:
  typename Left::Held left_;
  typename Right::Held right_;

 public:
  using Held = ExpressionNode;
};

class LazyVec4 : public Expression<LazyVec4> {
 public:
  using Held = const LazyVec4&;

  LazyVec4() = default;
  explicit LazyVec4(const FourFloats& x) : lanes_{x[0], x[1], x[2], x[3]} {}
  template <class E>
  LazyVec4& operator=(const Expression<E>& expression) {
    lanes_ = expression.self().lanes();
    return *this;
  }
  [[nodiscard]] PackedFloats lanes() const { return lanes_; }

 private:
  PackedFloats lanes_{};
};

template <class L, class R>
[[nodiscard]] ExpressionNode<L, Plus, R> operator+(const Expression<L>& a, const Expression<R>& b) {
  return {a.self(), b.self()};
}
template <class L, class R>
[[nodiscard]] ExpressionNode<L, Minus, R> operator-(const Expression<L>& a, const Expression<R>& b) {
  return {a.self(), b.self()};
}
template <class L, class R>
[[nodiscard]] ExpressionNode<L, Times, R> operator*(const Expression<L>& a, const Expression<R>& b) {
  return {a.self(), b.self()};
}

}  // namespace raysweep
