// One test of ray and triangle, Möller & Trumbore's, that ends as soon as it knows, and one that computes
// everything and asks once: what Morozov 2011, 5.9.1, compares.
#include <fmt/format.h>

#include <bit>

#include "experiments/intersection/protocols.h"
#include "experiments/kernels/small_kernel.h"
#include "tracer/intersect/moller_trumbore.h"

namespace raysweep {

namespace {

using Constants = MollerTrumbore::Prepared<float>;

/// How far the hit is, infinity without one.
struct EarlyExits {
  static float test(const Ray<float>& ray, const Constants& triangle) {
    const auto hit = MollerTrumbore::intersect(ray, triangle);
    return hit ? hit->t : std::numeric_limits<float>::infinity();
  }
};

/// The same operations on the same numbers.
struct NoBranches {
  static float test(const Ray<float>& ray, const Constants& tri) {
    constexpr float infinity = std::numeric_limits<float>::infinity();
    const Vec3<float> p = cross(ray.direction, tri.ac);
    const float inverse = 1.0F / dot(tri.ab, p);
    const Vec3<float> ao = ray.origin - tri.a;
    const float beta = dot(ao, p) * inverse;
    const Vec3<float> q = cross(ao, tri.ab);
    const float gamma = dot(ray.direction, q) * inverse;
    const float t = dot(tri.ac, q) * inverse;
    // Comparisons as numbers: of && compilers make branches. Each is false of NaN.
    const auto is = [](bool holds) { return static_cast<unsigned>(holds); };
    const unsigned hit =
        is(beta >= 0) & is(beta <= 1) & is(gamma >= 0) & is(beta + gamma <= 1) & is(t > 0) & is(t < infinity);
    // All bits of t, or those of infinity: a selection by arithmetic, which none can make a branch of.
    const unsigned mask = 0U - hit;
    return std::bit_cast<float>((std::bit_cast<unsigned>(t) & mask) |
                                (std::bit_cast<unsigned>(infinity) & ~mask));
  }
};

template <class Test>
class TestPass : public SmallPass {
 public:
  TestPass(double hit_rate, uint64_t seed)
      : work_(find_protocol("hit-rate")->make(hit_rate, seed)), found_(work_.test_count()) {
    for (const Triangle<float>& triangle : work_.triangles)
      constants_.push_back(MollerTrumbore::prepare(triangle));
  }

  [[nodiscard]] uint64_t operations() const override { return work_.test_count(); }
  double run() override {
    test_all<Test>(found_);
    return static_cast<double>(found_.front());
  }
  [[nodiscard]] std::string why_wrong() override {
    std::vector<float> right(found_.size());
    test_all<EarlyExits>(right);
    test_all<Test>(found_);
    uint64_t hits = 0;
    for (size_t i = 0; i < found_.size(); ++i) {
      if (std::bit_cast<uint32_t>(found_[i]) != std::bit_cast<uint32_t>(right[i]))
        return fmt::format("test {} hits at {}, where {} is right", i, found_[i], right[i]);
      hits += found_[i] < std::numeric_limits<float>::infinity() ? 1U : 0U;
    }
    const KnownHits known = known_hits(work_);
    if (hits >= known.hits && hits <= known.hits + known.unclear) return {};
    return fmt::format("{} hits, where {} are certain and {} tests are unclear", hits, known.hits,
                       known.unclear);
  }

 private:
  template <class Any>
  void test_all(std::vector<float>& found) const {
    float* next = found.data();
    for (const Visit<float>& visit : work_.visits) {
      for (uint32_t r = 0; r < work_.rays_a_visit; ++r) {
        const Ray<float> ray = work_.rays[visit.first_ray + r];
        for (uint32_t i = 0; i < visit.triangle_count; ++i)
          *next++ = Any::test(ray, constants_[visit.first_triangle + i]);
      }
    }
  }

  Workload<float> work_;
  std::vector<Constants> constants_;
  std::vector<float> found_;
};

std::unique_ptr<SmallPass> prepare_branches(const FactorValues& values, uint64_t seed) {
  const double hit_rate = number_of(values, "hit_rate");
  if (values.at("branches") == "yes") return std::make_unique<TestPass<EarlyExits>>(hit_rate, seed);
  return std::make_unique<TestPass<NoBranches>>(hit_rate, seed);
}

}  // namespace

SmallKernel branches_kernel() {
  return {"branches",
          "a ray against a triangle, with early exits, or all computed and combined by &",
          "test",
          {{"branches", {"yes", "no"}},
           {"hit_rate", {}, 0, 1, 1.0 / run_length, {0, 0.1, 0.3, 0.5, 0.7, 0.9, 1}}},
          [](const FactorValues&) { return std::string(); },
          prepare_branches,
          // Both passes and what is made for them are short beside samples.
          [](const FactorValues&) { return 0.0; }};
}

}  // namespace raysweep
