#include "experiments/intersection/kernel.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <set>

#include "experiments/intersection/compiler_name.h"
#include "experiments/intersection/draw.h"
#include "experiments/intersection/kernel_modules.h"
#include "experiments/intersection/variant_names.h"
#include "tracer/intersect/all.h"
#include "tracer/intersect/study.h"

namespace raysweep {
namespace {

/// Runs of every length up to two groups, one after the other, each against a group of rays of which some are
/// aimed at corners and edges, and one has a number that is none.
template <class T>
Workload<T> awkward_work() {
  Random random(7);
  const auto coordinate = [&] { return static_cast<T>(2 * uniform(random) - 1); };
  const auto point = [&] { return Vec3<T>(coordinate(), coordinate(), coordinate()); };
  Workload<T> work;
  work.rays_a_visit = widest_group;
  for (uint32_t count = 1; count <= 2 * widest_group; ++count) {
    const auto first_ray = static_cast<uint32_t>(work.rays.size());
    const auto first_triangle = static_cast<uint32_t>(work.triangles.size());
    for (uint32_t i = 0; i < count; ++i) {
      const Vec3<T> a = point(), b = point();
      work.triangles.push_back({a, b, i % 7 == 6 ? a : point()});
    }
    for (uint32_t r = 0; r < widest_group; ++r) {
      const Vec3<T> origin = point() * T(3);
      const Triangle<T>& target = work.triangles[first_triangle + r % count];
      const Vec3<T> end = r % 3 == 0 ? target.a : r % 3 == 1 ? (target.a + target.b) * T(0.5) : point();
      work.rays.push_back({origin, end - origin});
    }
    work.rays.back().direction.y =
        count % 2 == 0 ? std::numeric_limits<T>::quiet_NaN() : std::numeric_limits<T>::infinity();
    const T t_max = count % 3 == 0 ? T(1) : std::numeric_limits<T>::infinity();
    work.visits.push_back({first_ray, first_triangle, count, t_max});
  }
  return work;
}

/// Of one ray and triangle at a time, as the program itself is compiled.
template <class T>
bool is_plain(const Kernel<T>& kernel) {
  return kernel.rays == 1 && kernel.triangles == 1 && kernel.layout == "aos" && kernel.contraction == "off" &&
         kernel.isa == "baseline" && kernel.compiler == compiler_name;
}

/// Whether nothing that may change a bit differs from the plain kernel of its variant: lanes may have another
/// estimate of reciprocals.
template <class T>
bool rounds_as_plain(const Kernel<T>& kernel) {
  return !is_plain(kernel) && kernel.contraction == "off" && kernel.variant.reciprocal == Reciprocal::exact;
}

template <class T>
const Kernel<T>& plain_of(const Kernel<T>& kernel) {
  for (const Kernel<T>& one : all_kernels<T>()) {
    if (one.method == kernel.method && one.variant == kernel.variant && is_plain(one)) return one;
  }
  throw std::logic_error("a variant without a plain kernel");
}

bool are_same(const Answer& a, const Answer& b) {
  const auto same = [](double x, double y) {
    return std::bit_cast<uint64_t>(x) == std::bit_cast<uint64_t>(y) || (std::isnan(x) && std::isnan(y));
  };
  return a.hit == b.hit && same(a.t, b.t) && same(a.beta, b.beta) && same(a.gamma, b.gamma);
}

template <class T>
size_t differences(const std::vector<Answer>& some, const std::vector<Answer>& others) {
  EXPECT_EQ(some.size(), others.size());
  size_t count = 0;
  for (size_t i = 0; i < some.size(); ++i) count += are_same(some[i], others[i]) ? 0 : 1;
  return count;
}

template <class T>
struct kernel : testing::Test {};
using Precisions = testing::Types<float, double>;
TYPED_TEST_SUITE(kernel, Precisions);

TYPED_TEST(kernel, of_many_lanes_answers_as_the_one_of_one_ray_bit_for_bit) {
  const Workload<TypeParam> work = awkward_work<TypeParam>();
  size_t tried = 0;
  for (const Kernel<TypeParam>& one : all_kernels<TypeParam>()) {
    if (!rounds_as_plain(one)) continue;
    SCOPED_TRACE(fmt::format("{} {}", one.method, one.change));
    EXPECT_EQ(
        differences<TypeParam>(one.prepare(work)->answers(work), plain_of(one).prepare(work)->answers(work)),
        0u);
    ++tried;
  }
  if (best_lanes().empty()) GTEST_SKIP() << "no module of lanes here";
  EXPECT_GT(tried, 14u * 4);
}

TYPED_TEST(kernel, counts_the_hits_that_it_answers) {
  const Workload<TypeParam> work = awkward_work<TypeParam>();
  for (const Kernel<TypeParam>& one : all_kernels<TypeParam>()) {
    SCOPED_TRACE(fmt::format("{} {}", one.method, one.change));
    const auto pass = one.prepare(work);
    const std::vector<Answer> answers = pass->answers(work);
    uint64_t hits = 0;
    double sum = 0;
    for (const Answer& answer : answers) {
      if (!answer.hit) continue;
      ++hits;
      if (!std::isnan(answer.t)) sum += answer.t;
      if (!std::isnan(answer.beta)) sum += answer.beta + answer.gamma;
    }
    const PassResult result = pass->run();
    EXPECT_EQ(result.hits, hits);
    EXPECT_GT(hits, 100u);
    // With decisions folded into t, the ray that has NaN hits at NaN.
    if (one.variant.early_out == EarlyOut::folded) continue;
    EXPECT_NEAR(result.sum, sum, 1e-3 * (1 + std::abs(sum)));
  }
}

// Else what is called contracted would be nothing else than the rest.
TYPED_TEST(kernel, with_contraction_rounds_otherwise) {
  if (const std::string why = why_no_kernels("contracted"); !why.empty())
    GTEST_SKIP() << "the module of contracted kernels " << why;
  const Workload<TypeParam> work = awkward_work<TypeParam>();
  for (const Kernel<TypeParam>& one : all_kernels<TypeParam>()) {
    if (one.contraction != "on") continue;
    SCOPED_TRACE(one.method);
    EXPECT_GT(
        differences<TypeParam>(one.prepare(work)->answers(work), plain_of(one).prepare(work)->answers(work)),
        0u);
  }
}

TYPED_TEST(kernel, of_the_tracer_s_methods_is_there_for_all_that_factors_can_be_at_once) {
  if (const std::string why = why_no_kernels("combined"); !why.empty())
    GTEST_SKIP() << "the module of combined kernels " << why;
  for_each_method([]<class Method>(Method) {
    size_t expected = 0;
    for_each_combination<Method, TypeParam>([&]<Variant variant>() {
      size_t found = 0;
      for (const Kernel<TypeParam>& one : all_kernels<TypeParam>())
        found += one.method == Method::name && one.variant == variant && is_plain(one) ? 1 : 0;
      EXPECT_EQ(found, 1u) << Method::name << " " << change_of(base_variant<Method>(), variant);
      ++expected;
    });
    EXPECT_GE(expected, 50u);
  });
}

TYPED_TEST(kernel, has_a_name_of_its_own) {
  std::set<std::string> names;
  for (const Kernel<TypeParam>& one : all_kernels<TypeParam>())
    EXPECT_TRUE(names.insert(fmt::format("{} {}", one.method, one.change)).second)
        << one.method << " " << one.change;
}

TEST(kernel_modules, that_are_not_there_say_why) {
  EXPECT_THROW((void)why_no_kernels("abacus"), std::out_of_range);
  for (const KernelModuleInfo& module : all_kernel_modules()) {
    const std::string why = why_no_kernels(module.name);
    if (why.empty()) {
      EXPECT_EQ(load_kernels(module.name).layout, kernel_layout);
    } else {
      EXPECT_THROW((void)load_kernels(module.name), std::runtime_error);
    }
  }
}

}  // namespace
}  // namespace raysweep
