#include "experiments/intersection/protocols.h"

#include <algorithm>
#include <cmath>

#include "experiments/intersection/draw.h"

namespace raysweep {

namespace {

/// 256 triangles of 128 bytes, which is as much as any method keeps of one in double, are within 32 KB.
constexpr uint32_t random_triangle_count = 256;

/// Predictors of branches remember the outcomes of tests that are repeated: measured on a Xeon, Plücker's
/// method takes 10 ns a test where half of 10,240 are hits, 17 ns of 40,960, 18 ns of 81,920. So protocols
/// with early outs have about as many as the last, or more.
constexpr uint32_t random_ray_count = 512, hit_rate_ray_count = 1024;

Vec3d point_in_box(Random& random) {
  const auto coordinate = [&] { return 2 * uniform(random) - 1; };
  const double x = coordinate(), y = coordinate();
  return {x, y, coordinate()};
}

/// Kensler & Shirley 2006, "Optimizing ray-triangle intersection via automated search": corners anywhere.
Triangle<float> any_triangle(Random& random) {
  const Vec3d a = point_in_box(random), b = point_in_box(random);
  return rounded<float>({a, b, point_in_box(random)});
}

/// The target of the second point is at t = |target − origin|.
struct AimedRay {
  Vec3d origin, target;

  /// Not nearer to each other than half the box's half edge.
  explicit AimedRay(Random& random) {
    do {
      origin = point_in_box(random);
      target = point_in_box(random);
    } while (length(target - origin) < 0.5);
  }
  [[nodiscard]] Ray<float> ray() const { return aimed(Vec3f(origin), Vec3f(target)); }
};

void add_random_triangles(Workload<float>& work, uint32_t count, Random& random) {
  for (uint32_t i = 0; i < count; ++i) work.triangles.push_back(any_triangle(random));
}

Workload<float> random_work(double, uint64_t seed) {
  Random random(seed);
  Workload<float> work;
  add_random_triangles(work, random_triangle_count, random);
  for (uint32_t i = 0; i < random_ray_count; ++i) {
    work.rays.push_back(AimedRay(random).ray());
    work.visits.push_back({i, 0, random_triangle_count});
  }
  return work;
}

Triangle<float> missed_triangle(const Ray<float>& ray, Random& random) {
  for (;;) {
    const Triangle<float> triangle = any_triangle(random);
    if (clarity_of(ray, triangle, Visit<float>().t_max) == Clarity::miss) return triangle;
  }
}

/// Any triangle, moved until a point of it with weights of 0.1 at least is on the way to the target.
Triangle<float> hit_triangle(const AimedRay& aim, Random& random) {
  constexpr double least = 0.1;
  for (;;) {
    const Triangle<float> drawn = any_triangle(random);
    double beta = uniform(random), gamma = uniform(random);
    if (beta + gamma > 1) {
      beta = 1 - beta;
      gamma = 1 - gamma;
    }
    beta = least + (1 - 3 * least) * beta;
    gamma = least + (1 - 3 * least) * gamma;
    const Vec3d a(drawn.a), b(drawn.b), c(drawn.c);
    const Vec3d inside = a + (b - a) * beta + (c - a) * gamma;
    const Vec3d on_ray = aim.origin + (aim.target - aim.origin) * (0.1 + 0.9 * uniform(random));
    const Triangle<float> triangle = rounded<float>(moved({a, b, c}, on_ray - inside));
    if (clarity_of(aim.ray(), triangle, Visit<float>().t_max) == Clarity::hit) return triangle;
  }
}

template <class Value>
void shuffle(std::vector<Value>& list, Random& random) {
  for (size_t i = list.size(); i > 1; --i) std::swap(list[i - 1], list[random.index(i)]);
}

/// Löfstedt & Akenine-Möller 2005, "An evaluation framework for ray-triangle intersection algorithms": by the
/// share of hits. Each ray has triangles of its own, which are read one after the other: caches fetch them
/// ahead.
Workload<float> hit_rate_work(double hit_rate, uint64_t seed) {
  Random random(seed);
  Workload<float> work;
  for (uint32_t i = 0; i < hit_rate_ray_count; ++i) {
    const AimedRay aim(random);
    std::vector<Triangle<float>> run;
    const auto hits = static_cast<size_t>(std::lround(hit_rate * run_length));
    while (run.size() < hits) run.push_back(hit_triangle(aim, random));
    while (run.size() < run_length) run.push_back(missed_triangle(aim.ray(), random));
    shuffle(run, random);
    work.rays.push_back(aim.ray());
    work.visits.push_back({i, i * run_length, run_length});
    work.triangles.insert(work.triangles.end(), run.begin(), run.end());
  }
  return work;
}

/// Packets of 4 × 4 rays to the points of a lattice, as far from each other as pixels of a picture that is
/// 256 of them wide and as wide as it is far. Origins lie within `origin_spread` of such a step.
Workload<float> packet_work(double origin_spread, uint64_t seed) {
  constexpr uint32_t packet_count = 32, side = 4;
  static_assert(side * side == widest_group);
  Random random(seed);
  Workload<float> work;
  work.rays_a_visit = widest_group;
  add_random_triangles(work, random_triangle_count, random);
  for (uint32_t packet = 0; packet < packet_count; ++packet) {
    const AimedRay aim(random);
    const Vec3d way = aim.target - aim.origin;
    const Vec3d right = any_tangent(normalize(way), random), up = cross(normalize(way), right);
    const double step = length(way) / 256;
    for (uint32_t i = 0; i < widest_group; ++i) {
      const uint32_t column = i % side, row = i / side;
      const Vec3d target = aim.target + right * (step * column) + up * (step * row);
      const Vec3d origin = aim.origin + point_in_ball(random) * (step * origin_spread);
      work.rays.push_back(aimed(Vec3f(origin), Vec3f(target)));
    }
    work.visits.push_back({packet * widest_group, 0, random_triangle_count});
  }
  return work;
}

Workload<float> common_packets(double, uint64_t seed) { return packet_work(0, seed); }
Workload<float> general_packets(double, uint64_t seed) { return packet_work(4, seed); }

/// The kernel of a study of threads and vectors at once: one ray with four triangles that lie together.
Workload<float> cluster_work(double size, uint64_t seed) {
  constexpr uint32_t cluster = 4;
  const auto count = static_cast<uint32_t>(size);
  Random random(seed);
  Workload<float> work;
  add_random_triangles(work, count, random);
  for (uint32_t i = 0; i < count; ++i) {
    work.rays.push_back(AimedRay(random).ray());
    for (uint32_t first = 0; first < count; first += cluster) work.visits.push_back({i, first, cluster});
  }
  return work;
}

}  // namespace

const std::vector<Protocol>& all_protocols() {
  static const std::vector<Protocol> protocols{
      {"random", "rays and triangles between points anywhere in a box (Kensler & Shirley 2006)", false, false,
       false, 1, random_work},
      {"hit-rate", "each ray with a run of triangles of which it hits a given share, in any order", true,
       false, false, 1, hit_rate_work},
      {"worst-case",
       "the same, where no test ends early: kernels without early outs, and all others at the hit rate 1",
       true, false, false, 1, hit_rate_work},
      {"packet-common", "random, in packets of 16 rays from one origin", false, false, false, widest_group,
       common_packets},
      {"packet-general", "random, in packets of 16 rays from origins of their own", false, false, false,
       widest_group, general_packets},
      {"replay", "the tests that a hierarchy leaves of camera, shadow and bounced rays in a scene", false,
       false, true, 1, nullptr},
      {"clusters", "each ray with all triangles, four at a time; as many rays as triangles", false, true,
       false, 1, cluster_work}};
  return protocols;
}

const Protocol* find_protocol(std::string_view name) {
  const auto& all = all_protocols();
  const auto found = std::find_if(all.begin(), all.end(), [&](const Protocol& p) { return p.name == name; });
  return found == all.end() ? nullptr : &*found;
}

const std::vector<double>& cluster_sizes() {
  // From what the first cache holds of rays, triangles and visits to what the second one does.
  static const std::vector<double> sizes{64, 128, 256, 512};
  return sizes;
}

template <class T>
Workload<T> work_in(const Workload<float>& work) {
  Workload<T> result;
  result.rays_a_visit = work.rays_a_visit;
  for (const Ray<float>& ray : work.rays)
    result.rays.push_back({Vec3<T>(ray.origin), Vec3<T>(ray.direction)});
  for (const Triangle<float>& triangle : work.triangles)
    result.triangles.push_back(triangle.template as<T>());
  for (const Visit<float>& v : work.visits)
    result.visits.push_back({v.first_ray, v.first_triangle, v.triangle_count, T(v.t_max)});
  return result;
}
template Workload<float> work_in(const Workload<float>&);
template Workload<double> work_in(const Workload<float>&);

template <class T>
Workload<T> share_of(const Workload<T>& work, uint32_t index, uint32_t count) {
  const auto border = [&](uint32_t i) {
    return work.visits.begin() + static_cast<std::ptrdiff_t>(work.visits.size() * i / count);
  };
  return {work.rays, work.triangles, {border(index), border(index + 1)}, work.rays_a_visit};
}
template Workload<float> share_of(const Workload<float>&, uint32_t, uint32_t);
template Workload<double> share_of(const Workload<double>&, uint32_t, uint32_t);

}  // namespace raysweep
