// Lists of tests are what their protocols say, and all kernels agree about them.
#include "experiments/intersection/protocols.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "experiments/intersection/oracle.h"

namespace raysweep {
namespace {

Workload<float> made(std::string_view protocol, double parameter = 0, uint64_t seed = 1) {
  return find_protocol(protocol)->make(parameter, seed);
}

bool are_equal(const Workload<float>& a, const Workload<float>& b) {
  const auto same_ray = [](const Ray<float>& r, const Ray<float>& s) {
    return r.origin == s.origin && r.direction == s.direction;
  };
  const auto same_triangle = [](const Triangle<float>& t, const Triangle<float>& u) {
    return t.a == u.a && t.b == u.b && t.c == u.c;
  };
  return std::ranges::equal(a.rays, b.rays, same_ray) &&
         std::ranges::equal(a.triangles, b.triangles, same_triangle);
}

struct Verdicts {
  uint64_t hits = 0, boundary = 0;
};

Verdicts verdicts_of(const Workload<float>& work) {
  Verdicts verdicts;
  for (const Visit<float>& visit : work.visits) {
    for (uint32_t r = 0; r < work.rays_a_visit; ++r) {
      for (uint32_t i = 0; i < visit.triangle_count; ++i) {
        const ExactVerdict verdict = exact_verdict(work.rays[visit.first_ray + r],
                                                   work.triangles[visit.first_triangle + i], visit.t_max);
        verdicts.hits += verdict == ExactVerdict::hit;
        verdicts.boundary += verdict == ExactVerdict::boundary;
      }
    }
  }
  return verdicts;
}

TEST(protocols, hit_exactly_the_share_that_is_asked_for) {
  for (const char* name : {"hit-rate", "worst-case"}) {
    for (int tenths = 0; tenths <= 10; ++tenths) {
      const Workload<float> work = made(name, tenths / 10.0);
      const Verdicts verdicts = verdicts_of(work);
      EXPECT_EQ(verdicts.hits * 10, work.test_count() * static_cast<uint64_t>(tenths)) << name;
      EXPECT_EQ(verdicts.boundary, 0u);
    }
  }
}

TEST(protocols, hits_of_a_ray_stand_in_no_order) {
  const Workload<float> work = made("hit-rate", 0.5);
  size_t changes = 0;
  for (uint32_t i = 1; i < run_length; ++i) {
    const auto hit = [&](uint32_t at) { return exact_verdict(work.rays[0], work.triangles[at]); };
    changes += hit(i) != hit(i - 1);
  }
  EXPECT_GT(changes, run_length / 4) << "half of the neighbours differ where hits and misses are shuffled";
}

TEST(protocols, with_a_hit_rate_have_no_test_that_rounding_decides) {
  for (const double rate : {0.0, 0.3, 1.0}) {
    const Workload<float> work = made("hit-rate", rate);
    const KnownHits known = known_hits(work);
    EXPECT_EQ(known.unclear, 0u);
    EXPECT_EQ(known.hits, verdicts_of(work).hits);
  }
}

TEST(protocols, clear_tests_are_what_the_oracle_says) {
  for (const char* name : {"random", "packet-common", "packet-general", "clusters"}) {
    const Workload<float> work = made(name, 128);
    const KnownHits known = known_hits(work);
    const Verdicts verdicts = verdicts_of(work);
    EXPECT_GE(verdicts.hits, known.hits) << name;
    EXPECT_LE(verdicts.hits + verdicts.boundary, known.hits + known.unclear) << name;
    EXPECT_LT(known.unclear * 100, work.test_count()) << name << ": few are unclear";
    EXPECT_GT(known.hits * 100, work.test_count()) << name << ": some are hits";
  }
}

TEST(clarity, ends_near_edges_ends_and_planes) {
  const Triangle<float> triangle{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  const auto clarity = [&](const Vec3f& from, const Vec3f& to, float t_max) {
    return clarity_of({from, to - from}, triangle, t_max);
  };
  EXPECT_EQ(clarity({0.2f, 0.2f, 1}, {0.2f, 0.2f, 0}, 2), Clarity::hit);
  EXPECT_EQ(clarity({0.2f, 0.2f, 1}, {0.2f, 0.2f, 0}, 0.5f), Clarity::miss) << "behind the end";
  EXPECT_EQ(clarity({0.2f, 0.2f, 1}, {0.2f, 0.2f, 0}, 1), Clarity::unclear) << "at the end";
  EXPECT_EQ(clarity({0.2f, 0.2f, -1}, {0.2f, 0.2f, -2}, 2), Clarity::miss) << "behind the origin";
  EXPECT_EQ(clarity({2, 0.2f, 1}, {2, 0.2f, 0}, 2), Clarity::miss);
  EXPECT_EQ(clarity({0.2f, 1e-6f, 1}, {0.2f, 1e-6f, 0}, 2), Clarity::unclear) << "at an edge";
  EXPECT_EQ(clarity({0.2f, 0.2f, 0}, {0.4f, 0.2f, 0}, 2), Clarity::unclear) << "in the plane";
  EXPECT_EQ(clarity_of({{0.2f, 0.2f, 1}, {0, 0, -1}}, {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, 2), Clarity::unclear)
      << "without area";
}

TEST(protocols, make_packets_of_coherent_rays) {
  for (const char* name : {"packet-common", "packet-general"}) {
    const Workload<float> work = made(name);
    EXPECT_EQ(work.rays_a_visit, widest_group);
    EXPECT_EQ(work.rays.size(), work.visits.size() * widest_group);
    for (const Visit<float>& visit : work.visits) {
      const Ray<float>& first = work.rays[visit.first_ray];
      for (uint32_t i = 1; i < widest_group; ++i) {
        const Ray<float>& ray = work.rays[visit.first_ray + i];
        EXPECT_EQ(ray.origin == first.origin, std::string_view(name) == "packet-common");
        EXPECT_GT(dot(ray.direction, first.direction), 0.99f);
        EXPECT_FALSE(ray.direction == first.direction);
      }
    }
  }
}

TEST(protocols, clusters_hand_each_ray_every_triangle_four_at_a_time) {
  for (const double size : cluster_sizes()) {
    const Workload<float> work = made("clusters", size);
    EXPECT_EQ(static_cast<double>(work.test_count()), size * size);
    for (const Visit<float>& visit : work.visits) EXPECT_EQ(visit.triangle_count, 4u);
  }
}

TEST(protocols, depend_on_the_seed_alone) {
  for (const Protocol& protocol : all_protocols()) {
    if (!protocol.make) continue;
    const double parameter = protocol.has_size ? 64 : 0.5;
    const auto first = protocol.make(parameter, 1);
    EXPECT_TRUE(are_equal(first, protocol.make(parameter, 1))) << protocol.name;
    EXPECT_FALSE(are_equal(first, protocol.make(parameter, 2))) << protocol.name;
  }
}

TEST(protocols, are_shared_among_threads_whole) {
  const Workload<float> work = made("random");
  for (const uint32_t count : {1u, 2u, 3u}) {
    uint32_t next = 0;
    for (uint32_t i = 0; i < count; ++i) {
      const Workload<float> share = share_of(work, i, count);
      EXPECT_NEAR(static_cast<double>(share.visits.size()), static_cast<double>(work.visits.size()) / count,
                  1);
      for (const Visit<float>& visit : share.visits) EXPECT_EQ(visit.first_ray, next++);
    }
    EXPECT_EQ(next, work.visits.size());
  }
}

template <class T>
void expect_known_hits_of_every_kernel(std::string_view protocol, double parameter) {
  const Workload<float> work = share_of(made(protocol, parameter), 0, 4);  // slow methods take their time
  const KnownHits known = known_hits(work);
  const Workload<T> as_tested = work_in<T>(work);
  for (const Kernel<T>& kernel : all_kernels<T>()) {
    if (work.rays_a_visit % kernel.rays != 0) continue;
    const uint64_t hits = kernel.prepare(as_tested)->run().hits;
    EXPECT_GE(hits, known.hits) << kernel.method << ' ' << kernel.change << ' ' << protocol;
    EXPECT_LE(hits, known.hits + known.unclear) << kernel.method << ' ' << kernel.change << ' ' << protocol;
  }
}

TEST(protocols, all_kernels_agree_wherever_rounding_does_not_decide) {
  for (const char* protocol : {"random", "hit-rate", "packet-common", "packet-general"}) {
    expect_known_hits_of_every_kernel<float>(protocol, 0.3);
    expect_known_hits_of_every_kernel<double>(protocol, 0.3);
  }
}

}  // namespace
}  // namespace raysweep
