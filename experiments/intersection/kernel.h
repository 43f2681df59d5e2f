// What is timed: every method of the study in every variant and shape, over a given list of tests.
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "tracer/intersect/intersector.h"
#include "tracer/intersect/variant.h"

/// All that a pass calls becomes part of it: left to the compiler, calls cost more than some formulas. Not
/// under sanitizers, whose code would then take many minutes to compile.
#ifdef RAYSWEEP_CALLS_STAY
#define RAYSWEEP_FLATTEN
#else
#define RAYSWEEP_FLATTEN [[gnu::flatten]]
#endif

namespace raysweep {

/// The most rays or triangles that a kernel takes at once.
constexpr uint32_t widest_group = 16;

/// A group of rays against a run of triangles, each with each.
template <class T>
struct Visit {
  uint32_t first_ray = 0;
  uint32_t first_triangle = 0, triangle_count = 0;
  T t_max = std::numeric_limits<T>::infinity();
};

/// Tests to be done. A visit has `rays_a_visit` rays: 1, or `widest_group` where packets shall take part. A
/// kernel for n triangles at once reads its runs in steps of n: where a count is no multiple of
/// `widest_group`, lanes of its last step go to waste, as they do in a leaf; they test what follows in
/// `triangles`, or nothing, and are not counted as hits.
template <class T>
struct Workload {
  std::vector<Ray<T>> rays;
  std::vector<Triangle<T>> triangles;
  std::vector<Visit<T>> visits;
  uint32_t rays_a_visit = 1;

  /// Tests of a pass: of one ray with one triangle.
  [[nodiscard]] uint64_t test_count() const {
    uint64_t count = 0;
    for (const Visit<T>& visit : visits) count += uint64_t{visit.triangle_count} * rays_a_visit;
    return count;
  }
};

/// What one pass found: so that no compiler leaves tests out, and that kernels can be compared. `hits` is the
/// same for all variants of a method in the same precision that compare the same numbers; `sum` adds up what
/// hits were asked for, t, β and γ, in some order and in the kernel's precision.
struct PassResult {
  uint64_t hits = 0;
  double sum = 0;
};

/// Of one test; NaN stands for what is not given. Numbers of float kernels are those of float.
struct Answer {
  bool hit = false;
  double t = nothing, beta = nothing, gamma = nothing;

  static constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
};

/// A kernel with its constants computed and its data laid out. `Workload` must outlive it.
class KernelPass {
 public:
  KernelPass() = default;
  virtual ~KernelPass() = default;
  KernelPass(const KernelPass&) = delete;
  KernelPass& operator=(const KernelPass&) = delete;

  /// All visits once: what is timed.
  [[nodiscard]] PassResult run() { return run(nullptr); }
  /// The same, with what each test says: for each visit, of each of its rays, its triangles in turn.
  [[nodiscard]] std::vector<Answer> answers(const auto& work) {
    std::vector<Answer> all(work.test_count());
    (void)run(all.data());
    return all;
  }

 private:
  /// Hits are written to `answers` unless it is null.
  [[nodiscard]] virtual PassResult run(Answer* answers) = 0;
};

/// A method in one variant and shape over numbers of type `T`, float or double.
template <class T>
struct Kernel {
  std::string_view method;
  std::string change;  // what differs from the method's base kernel: "division=late", "rays=8"; or "base"
  Variant variant;
  uint32_t rays = 1, triangles = 1;      // at once
  std::string_view layout = "aos";       // of triangles: aos, soa, blocks
  std::string_view contraction = "off";  // of a·b + c into one operation
  std::string_view compiler;             // "gcc 12.2.0"
  std::string_view isa;                  // "scalar", or the instruction set of its lanes
  uint32_t bytes = 0;                    // that a test reads of a triangle
  bool combines = false;                 // whether several factors differ at once: none of the star
  /// `work.rays_a_visit` must be a multiple of `rays`.
  std::unique_ptr<KernelPass> (*prepare)(const Workload<T>& work);
};

/// Of each method its base kernel (one ray, one triangle, base variant), then those that differ from it in
/// one factor, as far as they apply, modules have them and this machine can run them.
template <class T>
[[nodiscard]] const std::vector<Kernel<T>>& all_kernels();

}  // namespace raysweep
