// Several rays with one triangle, or several triangles with one ray, at a time. For modules alone, as
// lanes.h.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>
#include <map>
#include <type_traits>
#include <utility>
#include <vector>

#include "experiments/intersection/kernel.h"
#include "experiments/intersection/lanes.h"
#include "experiments/intersection/layout.h"
#include "tracer/intersect/solve.h"

namespace raysweep {

/// What the lanes of a pass add up, and where their answers go, if anybody wants them.
template <Variant variant, class V>
class LaneSums {
 public:
  explicit LaneSums(Answer* answers = nullptr) : answers_(answers) {}

  /// `lanes` are those that count; the answer of lane i has the number first + i·stride.
  void take(const Solution<V>& found, const typename V::Mask& lanes, size_t first, size_t stride) {
    const auto accepted = both(found.accepted, lanes);
    if (none(accepted)) return;
    hits_ += V::count(accepted);
    V numbers = found.t;
    if constexpr (variant.output == Output::weights) numbers = numbers + found.beta + found.gamma;
    if constexpr (variant.output != Output::hit) sum_ = sum_ + select(accepted, numbers, V(0));
    if (answers_) answer(found, accepted, answers_ + first, stride);
  }
  [[nodiscard]] PassResult result() const {
    double sum = 0;
    for (const auto x : numbers_of(sum_)) sum += static_cast<double>(x);
    return {hits_, sum};
  }

 private:
  using Numbers = std::array<typename V::Number, V::width>;

  [[nodiscard]] static Numbers numbers_of(const V& lanes) {
    Numbers numbers;
    lanes.store(numbers.data());
    return numbers;
  }
  [[gnu::noinline]] static void answer(const Solution<V>& found, const typename V::Mask& accepted,
                                       Answer* answers, size_t stride) {
    const Numbers hit = numbers_of(select(accepted, V(1), V(0)));
    const Numbers t = numbers_of(found.t), beta = numbers_of(found.beta), gamma = numbers_of(found.gamma);
    for (size_t i = 0; i < V::width; ++i) {
      if (hit[i] > 0) answers[i * stride] = {true, t[i], beta[i], gamma[i]};
    }
  }

  uint64_t hits_ = 0;
  V sum_{0};
  Answer* answers_;
};

/// `width` rays of a visit with one triangle: its constants go to all lanes.
template <class Method, Variant variant, class T, int width>
class PacketPass : public KernelPass {
 public:
  explicit PacketPass(const Workload<T>& work) : work_(work) {
    for (const Triangle<T>& triangle : work.triangles) constants_.push_back(Method::prepare(triangle));
    for (size_t first = 0; first < work.rays.size(); first += width) packets_.push_back(packet_at(first));
  }

  RAYSWEEP_FLATTEN [[nodiscard]] PassResult run(Answer* answers) override {
    LaneSums<variant, V> sums(answers);
    const auto all = V::first(width);
    const uint32_t packets = work_.rays_a_visit / width;
    size_t answered = 0;  // before this packet
    for (const Visit<T>& visit : work_.visits) {
      const auto* const first = constants_.data() + visit.first_triangle;
      const V t_max(visit.t_max);
      for (uint32_t p = 0; p < packets; ++p) {
        const Ray<V>& rays = packets_[visit.first_ray / width + p];
        for (uint32_t i = 0; i < visit.triangle_count; ++i) {
          sums.take(solve_lanes<Method, variant, V>(rays, first[i].template as<V>(), t_max), all,
                    answered + i, visit.triangle_count);
        }
        answered += size_t{visit.triangle_count} * width;
      }
    }
    return sums.result();
  }

 private:
  // Of a method without constants the dropped axis, if it has one, is the ray's.
  using V = Lanes<T, width, has_constants<Method> ? Axes::shared : Axes::per_lane>;
  static_assert(has_constants<Method> == (variant.data == Data::precomputed));

  [[nodiscard]] Ray<V> packet_at(size_t first) const {
    const auto lanes_of = [&](auto number) {
      std::array<T, width> numbers;
      for (size_t i = 0; i < width; ++i) numbers[i] = number(work_.rays[first + i]);
      return V::load(numbers.data());
    };
    const auto vector_of = [&](Vec3<T> Ray<T>::*member) {
      return Vec3<V>(lanes_of([&](const Ray<T>& ray) { return (ray.*member).x; }),
                     lanes_of([&](const Ray<T>& ray) { return (ray.*member).y; }),
                     lanes_of([&](const Ray<T>& ray) { return (ray.*member).z; }));
    };
    return {vector_of(&Ray<T>::origin), vector_of(&Ray<T>::direction)};
  }

  const Workload<T>& work_;
  std::vector<TriangleFor<Method, variant, T>> constants_;
  std::vector<Ray<V>> packets_;
};

/// `width` triangles of a visit with one ray, whose numbers go to all lanes.
template <class Method, Variant variant, class T, int width, Layout layout>
class BlockPass : public KernelPass {
 public:
  explicit BlockPass(const Workload<T>& work) : work_(work) {
    if constexpr (layout == Layout::blocks) {
      for (const Visit<T>& visit : work.visits) lay_out(visit);
    } else {
      lay_out_all();
    }
  }

  RAYSWEEP_FLATTEN [[nodiscard]] PassResult run(Answer* answers) override {
    LaneSums<variant, V> sums(answers);
    const auto all = V::first(width);
    size_t answered = 0;  // before this ray
    for (size_t v = 0; v < work_.visits.size(); ++v) {
      const Visit<T>& visit = work_.visits[v];
      const V t_max(visit.t_max);
      for (uint32_t r = 0; r < work_.rays_a_visit; ++r) {
        const Ray<T>& one = work_.rays[visit.first_ray + r];
        const Ray<V> ray{Vec3<V>(one.origin), Vec3<V>(one.direction)};
        for (uint32_t i = 0; i < visit.triangle_count; i += width) {
          const size_t left = visit.triangle_count - i;
          sums.take(solve(ray, v, i, t_max), left >= width ? all : V::first(left), answered + i, 1);
        }
        answered += visit.triangle_count;
      }
    }
    return sums.result();
  }

 private:
  // Of a method without constants the dropped axis, if it has one, is the ray's: one for all lanes.
  using V = Lanes<T, width, has_constants<Method> ? Axes::per_lane : Axes::shared>;
  using Constants = TriangleFor<Method, variant, V>;
  static constexpr size_t number_count = sizeof(Constants) / sizeof(V);  // of a triangle
  static_assert(sizeof(Constants) == number_count * sizeof(V));

  /// Of `count` triangles from `first` on; the last one again where there are fewer than lanes.
  [[nodiscard]] Constants constants_at(size_t first, size_t count) const {
    const auto lanes_of = [&](auto number) {
      std::array<T, width> numbers;
      for (size_t i = 0; i < width; ++i) numbers[i] = number(work_.triangles[first + std::min(i, count - 1)]);
      return V::load(numbers.data());
    };
    const auto vector_of = [&](Vec3<T> Triangle<T>::*corner) {
      return Vec3<V>(lanes_of([&](const Triangle<T>& triangle) { return (triangle.*corner).x; }),
                     lanes_of([&](const Triangle<T>& triangle) { return (triangle.*corner).y; }),
                     lanes_of([&](const Triangle<T>& triangle) { return (triangle.*corner).z; }));
    };
    return Method::prepare(
        Triangle<V>{vector_of(&Triangle<T>::a), vector_of(&Triangle<T>::b), vector_of(&Triangle<T>::c)});
  }

  /// Runs that begin alike share their blocks, the longest having most.
  void lay_out(const Visit<T>& visit) {
    const auto [place, is_new] = places_.try_emplace({visit.first_triangle, visit.triangle_count},
                                                     static_cast<uint32_t>(blocks_.size()));
    block_of_visit_.push_back(place->second);
    if (!is_new) return;
    for (uint32_t i = 0; i < visit.triangle_count; i += width)
      blocks_.push_back(constants_at(visit.first_triangle + i, visit.triangle_count - i));
  }

  void lay_out_all() {
    const size_t count = work_.triangles.size();
    padded_count_ = count + width;
    numbers_.resize(number_count * padded_count_);
    for (size_t first = 0; first < count; first += width) {
      const Constants block = constants_at(first, count - first);
      for (size_t k = 0; k < number_count; ++k) {
        std::array<T, width> lanes;
        std::memcpy(lanes.data(), reinterpret_cast<const std::byte*>(&block) + k * sizeof(V), sizeof(V));
        for (size_t i = 0; i < width; ++i) {
          const size_t aos = (first + i) * number_count + k, soa = k * padded_count_ + first + i;
          numbers_[layout == Layout::aos ? aos : soa] = lanes[i];
        }
      }
    }
  }

  /// Number by number, so that each goes from memory to a register: a struct that is written as an array
  /// through its address makes GCC go through the stack, a union does not.
  [[nodiscard]] Constants read(size_t first) const {
    union Memory {
      V numbers[number_count];
      Constants constants;
      Memory() {}
    } memory;
    [&]<size_t... k>(std::index_sequence<k...>) {
      ((memory.numbers[k] = layout == Layout::aos
                                ? V::gather(&numbers_[first * number_count + k], number_count)
                                : V::load(&numbers_[k * padded_count_ + first])),
       ...);
    }
    (std::make_index_sequence<number_count>());
    return memory.constants;
  }

  [[nodiscard]] Solution<V> solve(const Ray<V>& ray, size_t visit, uint32_t i, const V& t_max) const {
    if constexpr (layout == Layout::blocks) {
      return solve_lanes<Method, variant, V>(ray, blocks_[block_of_visit_[visit] + i / width], t_max);
    } else {
      return solve_lanes<Method, variant, V>(ray, read(work_.visits[visit].first_triangle + i), t_max);
    }
  }

  const Workload<T>& work_;
  std::map<std::pair<uint32_t, uint32_t>, uint32_t> places_;  // of runs, by first triangle and count
  std::vector<uint32_t> block_of_visit_;
  std::vector<Constants> blocks_;
  std::vector<T> numbers_;
  size_t padded_count_ = 0;  // triangles that there is room for
};

}  // namespace raysweep
