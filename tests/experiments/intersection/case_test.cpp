// What the catalogue's cases promise of their rays and triangles, whatever a method makes of them.
#include "experiments/intersection/case.h"

#include <gtest/gtest.h>

#include <bit>
#include <map>
#include <numbers>
#include <set>

#include "experiments/intersection/index_mesh.h"
#include "experiments/intersection/oracle.h"

namespace raysweep {
namespace {

/// FNV-1a over the bits of every number.
class Hash {
 public:
  template <class T>
  void add(T number) {
    using Bits = std::conditional_t<sizeof(T) == 4, uint32_t, uint64_t>;
    // A NaN's sign and digits are free.
    const auto bits = std::isnan(number) ? Bits{1} : std::bit_cast<Bits>(number);
    for (size_t byte = 0; byte < sizeof(T); ++byte)
      value_ = (value_ ^ (bits >> (8 * byte) & 0xff)) * 0x100000001b3u;
  }
  template <class T>
  void add(const Vec3<T>& v) {
    add(v.x);
    add(v.y);
    add(v.z);
  }
  template <class T>
  void add(const Trials<T>& trials) {
    for (const Triangle<T>& t : trials.triangles) {
      add(t.a);
      add(t.b);
      add(t.c);
    }
    for (const Trial<T>& trial : trials.rays) {
      add(trial.ray.origin);
      add(trial.ray.direction);
      add(trial.t_max);
      add(static_cast<float>(trial.count));
    }
  }
  [[nodiscard]] uint64_t value() const { return value_; }

 private:
  uint64_t value_ = 0xcbf29ce484222325u;
};

template <class T>
uint64_t hash_of_all(uint64_t seed) {
  Hash hash;
  for (const Case& one : all_cases())
    for (const double difficulty : one.difficulties) hash.add(one.make<T>(difficulty, seed, 20));
  return hash.value();
}

/// Calls `visit(trial, triangle)` for each candidate of each ray.
template <class T, class Visit>
void for_each_pair(const Trials<T>& trials, const Visit& visit) {
  for (const Trial<T>& trial : trials.rays) {
    for (uint32_t i = trial.first; i < trial.first + trial.count; ++i)
      visit(trial, trials.triangles[trials.candidates[i]]);
  }
}

template <class T>
class Cases : public testing::Test {};
using Reals = testing::Types<float, double>;
TYPED_TEST_SUITE(Cases, Reals);

TEST(cases, are_those_of_the_catalogue_and_each_is_there_once) {
  std::multiset<std::string_view> ids;
  for (const Case& one : all_cases()) ids.insert(one.id);
  const std::multiset<std::string_view> expected{"W1", "W2", "W3", "W4", "W5", "W6",  "W7", "S1", "S2", "S3",
                                                 "S4", "F1", "F2", "D1", "D2", "D3",  "D4", "D5", "N2", "N4",
                                                 "N6", "N8", "E1", "E3", "E4", "F2e", "E5", "E6", "E7"};
  EXPECT_EQ(ids, expected);
  EXPECT_EQ(case_of("D3").title, "grazing ray");
  EXPECT_THROW((void)case_of("Z1"), std::out_of_range);
}

TYPED_TEST(Cases, have_as_many_rays_as_asked_for_and_finite_numbers_but_where_the_case_is_that) {
  using T = TypeParam;
  for (const Case& one : all_cases()) {
    for (const double difficulty : one.difficulties) {
      const Trials<T> trials = one.make<T>(difficulty, 3, 50);
      EXPECT_EQ(trials.rays.size(), 50u) << one.id;
      for_each_pair(trials, [&](const Trial<T>& trial, const Triangle<T>& triangle) {
        const bool is_finite = !exact_hit(trial.ray, triangle, trial.t_max).non_finite;
        EXPECT_EQ(is_finite, one.id != "N6") << one.id << " at " << difficulty;
      });
    }
  }
}

/// Found once, by GCC on x86-64; other compilers and processors must make the same numbers.
TEST(cases, of_a_seed_are_the_same_everywhere_and_others_of_another) {
  EXPECT_EQ(hash_of_all<float>(1), 16771363383326166392u);
  EXPECT_EQ(hash_of_all<double>(1), 7336434441649562882u);
  for (const Case& one : all_cases()) {
    Hash first, second;
    first.add(one.make<double>(one.difficulties.back(), 1, 20));
    second.add(one.make<double>(one.difficulties.back(), 2, 20));
    EXPECT_NE(first.value(), second.value()) << one.id;
  }
}

TEST(cases, spheres_are_closed_and_each_edge_belongs_to_two_triangles_that_turn_the_same_way) {
  Random random(7);
  for (const int around : {16, 32}) {
    std::map<std::pair<uint32_t, uint32_t>, int> edges;
    const IndexMesh mesh = sphere_mesh(around, 16, 2, 1, random);
    EXPECT_EQ(mesh.triangles.size(), static_cast<size_t>(2 * around * 15));
    for (const auto& corners : mesh.triangles)
      for (size_t side = 0; side < 3; ++side) ++edges[{corners[side], corners[(side + 1) % 3]}];
    for (const auto& [edge, count] : edges) {
      EXPECT_EQ(count, 1);
      EXPECT_TRUE(edges.contains({edge.second, edge.first}));
    }
  }
}

TEST(cases, turns_are_exact_at_quarters_and_elsewhere_those_of_the_standard_library) {
  EXPECT_EQ(Turn(0.25).cosine, 0);
  EXPECT_EQ(Turn(0.5).sine, 0);
  EXPECT_EQ(Turn(0.75).sine, -1);
  for (int i = 0; i <= 1024; ++i) {  // the share is exact
    const long double angle = 2 * std::numbers::pi_v<long double> * i / 1024;
    const Turn turn(i / 1024.0);
    EXPECT_LT(std::abs(turn.cosine - std::cos(angle)), 4e-16L) << i;
    EXPECT_LT(std::abs(turn.sine - std::sin(angle)), 4e-16L) << i;
  }
}

/// The least of a point's three weights, or the second, over the triangles around: how far it is from an edge
/// or a corner. Sorted, of all rays.
template <class T>
std::vector<long double> distances(std::string_view id, double difficulty, size_t weight) {
  std::vector<long double> all;
  const Trials<T> trials = case_of(id).make<T>(difficulty, 5, 2000);
  for (const Trial<T>& trial : trials.rays) {
    long double nearest = 1;
    for (uint32_t i = trial.first; i < trial.first + trial.count; ++i) {
      const ExactHit hit = exact_hit(trial.ray, trials.triangles[trials.candidates[i]]);
      if (hit.verdict == ExactVerdict::miss) continue;
      std::array<long double, 3> weights{hit.beta, hit.gamma, 1 - hit.beta - hit.gamma};
      std::sort(weights.begin(), weights.end());
      nearest = std::min(nearest, weights[weight]);
    }
    all.push_back(nearest);
  }
  std::sort(all.begin(), all.end());
  return all;
}

TYPED_TEST(Cases, rays_aimed_at_edges_and_corners_pass_within_ulps_of_them) {
  using T = TypeParam;
  const long double ulp = std::numeric_limits<T>::epsilon();
  for (const auto& [id, hardest, weight] :
       {std::tuple{"W1", 0.0, size_t{0}}, {"W2", 0.0, size_t{1}}, {"F2e", 1.0, size_t{0}}}) {
    const auto near = distances<T>(id, hardest, weight);
    EXPECT_LT(near[near.size() / 2], 2 * ulp) << id;
    // Triangles at poles are narrow, and some are seen flatly.
    EXPECT_LT(near[near.size() * 99 / 100], 32 * ulp) << id;
  }
  const auto beside = distances<T>("W1", 4096, 0);
  EXPECT_GT(beside[beside.size() / 2], 500 * ulp);
}

TYPED_TEST(Cases, rays_of_covered_cases_meet_a_candidate) {
  using T = TypeParam;
  for (const Case& one : all_cases()) {
    if (one.expectation != Expectation::covered) continue;
    for (const double difficulty : one.difficulties) {
      const Trials<T> trials = one.make<T>(difficulty, 9, 1000);
      std::map<const Trial<T>*, int> met;
      for_each_pair(trials, [&](const Trial<T>& trial, const Triangle<T>& triangle) {
        met[&trial] += exact_verdict(trial.ray, triangle) != ExactVerdict::miss;
      });
      for (const auto& [trial, count] : met) ASSERT_GT(count, 0) << one.id << " at " << difficulty;
    }
  }
}

TYPED_TEST(Cases, that_must_miss_have_no_plane_to_meet) {
  using T = TypeParam;
  for (const Case& one : all_cases()) {
    if (one.expectation != Expectation::must_miss) continue;
    for (const double difficulty : one.difficulties) {
      int boundaries = 0;
      for_each_pair(one.make<T>(difficulty, 9, 500), [&](const Trial<T>& trial, const Triangle<T>& triangle) {
        const ExactHit hit = exact_hit(trial.ray, triangle, trial.t_max);
        ASSERT_TRUE(std::isnan(hit.t)) << one.id << " at " << difficulty;
        boundaries += hit.verdict == ExactVerdict::boundary;
      });
      EXPECT_EQ(boundaries > 0, one.id == "D5") << one.id << ": in the plane, and only there";
    }
  }
}

TYPED_TEST(Cases, with_a_ray_behind_or_empty_have_no_hit_and_rays_that_end_at_a_hit_have_both) {
  using T = TypeParam;
  const auto hits = [](std::string_view id, double difficulty) {
    int count = 0;
    for_each_pair(case_of(id).make<T>(difficulty, 2, 1000),
                  [&](const Trial<T>& trial, const Triangle<T>& triangle) {
                    count += exact_verdict(trial.ray, triangle, trial.t_max) == ExactVerdict::hit;
                  });
    return count;
  };
  EXPECT_GT(hits("E7", 0), 600);
  EXPECT_EQ(hits("E7", 1), 0);
  EXPECT_EQ(hits("E7", 2), 0);
  for (const double ulps : case_of("E6").difficulties) {
    EXPECT_GT(hits("E6", ulps), 200) << ulps;
    EXPECT_LT(hits("E6", ulps), 600) << ulps;
  }
}

}  // namespace
}  // namespace raysweep
