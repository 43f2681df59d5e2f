// What patterns are for: how much of a pixel lies behind an edge.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <string>

#include "tracer/sample/pattern.h"

namespace raysweep {
namespace {

/// The half-plane of the points p with normal · (p − centre) < distance.
struct Edge {
  double x, y, distance;
  [[nodiscard]] bool covers(const Subpixel& p) const { return x * (p.x - 0.5) + y * (p.y - 0.5) < distance; }
};

/// Uniform in [0, 1), the same with every standard library.
double uniform(std::mt19937& generator) { return static_cast<double>(generator()) * 0x1p-32; }

/// An edge whose angle to the x axis is up to `widest`, and which meets the pixel.
Edge random_edge(std::mt19937& generator, double widest) {
  const double angle = std::numbers::pi / 2 + widest * (2 * uniform(generator) - 1);
  const double x = std::cos(angle), y = std::sin(angle);
  return {x, y, (uniform(generator) - 0.5) * (std::abs(x) + std::abs(y))};
}

/// The area of the pixel that `edge` covers. Across the edge the pixel is as wide as the convolution of two
/// boxes, |x| and |y| wide; the area is the integral of that trapezoid.
double covered_area(const Edge& edge) {
  const double a = std::abs(edge.x), b = std::abs(edge.y);
  const auto ramp = [](double t) { return t > 0 ? t * t / 2 : 0.0; };
  const double t = edge.distance + (a + b) / 2;
  return (ramp(t) - ramp(t - a) - ramp(t - b) + ramp(t - a - b)) / (a * b);
}

/// Root of the mean squared error of the covered share over many edges.
template <class MakePoints>
double edge_error(MakePoints make_points, double widest = std::numbers::pi) {
  constexpr int edges = 4000;
  std::mt19937 generator(1);
  double squares = 0;
  for (int i = 0; i < edges; ++i) {
    const Edge edge = random_edge(generator, widest);
    const std::vector<Subpixel> points = make_points(generator);
    double covered = 0;
    for (const Subpixel& p : points) covered += edge.covers(p);
    const double error = covered / static_cast<double>(points.size()) - covered_area(edge);
    squares += error * error / edges;
  }
  return std::sqrt(squares);
}

double edge_error_of(const std::string& pattern, int count, double widest = std::numbers::pi) {
  const auto points = make_pattern(pattern, count);
  return edge_error([&](std::mt19937&) { return points; }, widest);
}

double random_edge_error(int count) {
  return edge_error([&](std::mt19937& generator) {
    std::vector<Subpixel> points;
    for (int i = 0; i < count; ++i) {
      const double x = uniform(generator);
      points.push_back({x, uniform(generator)});
    }
    return points;
  });
}

constexpr double near_horizontal = 3 * std::numbers::pi / 180;

TEST(edges, covered_areas_by_hand) {
  EXPECT_NEAR(covered_area({0.6, 0.8, 0}), 0.5, 1e-12);
  EXPECT_NEAR(covered_area({0.6, 0.8, 0.7}), 1, 1e-12);
  const double r = 1 / std::sqrt(2);
  EXPECT_NEAR(covered_area({r, r, -r / 2}), 0.125, 1e-12) << "a corner triangle with legs of 1/2";
}

/// n random points have a standard error of √(mean of a·(1 − a) / n), 0.36/√n over these edges.
TEST(edges, random_points_err_as_theory_says) { EXPECT_NEAR(random_edge_error(64) * 8, 0.36, 0.03); }

TEST(edges, every_pattern_that_fills_the_pixel_beats_random_points) {
  for (const int count : {4, 16, 64, 256}) {
    const double random = random_edge_error(count);
    for (const char* pattern : {"grid", "rotated_grid", "halton", "sobol", "sobol:1", "sobol:2"}) {
      const double error = edge_error_of(pattern, count);
      EXPECT_LT(error, random * (count < 64 ? 0.8 : 0.5)) << pattern << ' ' << count;
    }
  }
}

/// Owen-scrambled nets: the variance over a discontinuity falls as n^(−3/2), an error of n^(−3/4); random
/// points fall as n^(−1/2).
TEST(edges, sobol_converges_faster_than_random_points) {
  for (const char* pattern : {"sobol", "sobol:1", "sobol:2"}) {
    const double order =
        std::log(edge_error_of(pattern, 4096) / edge_error_of(pattern, 16)) / std::log(4096.0 / 16);
    EXPECT_LT(order, -0.65) << pattern;
  }
}

/// A column of a grid's points changes side at once.
TEST(edges, near_the_axes_the_rotated_grid_beats_the_grid) {
  for (const int count : {4, 9, 16, 64}) {
    EXPECT_LT(edge_error_of("rotated_grid", count, near_horizontal),
              edge_error_of("grid", count, near_horizontal) * 0.7)
        << count;
  }
}

}  // namespace
}  // namespace raysweep
