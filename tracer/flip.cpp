#include "tracer/flip.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "tracer/compare.h"
#include "tracer/display_colour.h"
#include "tracer/separable_filter.h"

namespace raysweep {

namespace {

constexpr double pi = std::numbers::pi;

/// Exponents and bounds of the paper: q_c and q_f; p_c and p_t, which share out the colour differences.
constexpr double colour_exponent = 0.7, feature_exponent = 0.5, knee_share = 0.4, knee_value = 0.95;
/// Of the edges and points that are detected, in degrees (the paper's w).
constexpr double feature_width = 0.082;

/// `a·√(π/b)·exp(−π²x²/b)`, x in degrees: a term of a contrast sensitivity function, Fourier-transformed.
struct Term {
  double a, b;
};

/// The paper's table 1: luminance, red against green, blue against yellow.
constexpr Term luminance{1, 0.0047}, red_green{1, 0.0053}, blue_yellow[]{{34.1, 0.04}, {13.5, 0.025}};

double squared(double x) { return x * x; }

/// Of the filters by contrast sensitivity, in pixels: three standard deviations of the widest term.
int sensitivity_radius(double pixels_per_degree) {
  return static_cast<int>(std::ceil(3 * std::sqrt(blue_yellow[0].b / (2 * pi * pi)) * pixels_per_degree));
}

/// Of one term, without its factor.
FilterWeights sensitivity_kernel(const Term& term, double pixels_per_degree) {
  return kernel_of(sensitivity_radius(pixels_per_degree),
                   [&](double x) { return std::exp(-squared(pi * x / pixels_per_degree) / term.b); });
}

/// Of the sum of two terms over the picture's two dimensions, how much is the first's: not that of the sums
/// along one dimension.
double first_share(const Term& first, const FilterWeights& of_first, const Term& second,
                   const FilterWeights& of_second) {
  const auto volume = [](const Term& term, const FilterWeights& kernel) {
    return term.a * std::sqrt(pi / term.b) * squared(std::accumulate(kernel.begin(), kernel.end(), 0.0));
  };
  const double of_both = volume(first, of_first) + volume(second, of_second);
  return volume(first, of_first) / of_both;
}

/// A picture as a display shows it.
struct Shown {
  int width, height;
  std::vector<Vec3d> rgb;
};

Shown shown(const Film& film) {
  Shown picture{film.width(), film.height(), {}};
  const auto clamped = [](float value) { return value > 0 ? std::min(double(value), 1.0) : 0.0; };  // NaN: 0
  for (const Vec3f& p : film.pixels()) picture.rgb.push_back({clamped(p.x), clamped(p.y), clamped(p.z)});
  return picture;
}

/// What is left of it at the viewer's distance, in Hunt-adjusted L*a*b*.
std::vector<Vec3d> perceived(const Shown& picture, double pixels_per_degree) {
  ImagePlane channels[3]{
      {picture.width, picture.height}, {picture.width, picture.height}, {picture.width, picture.height}};
  for (size_t i = 0; i < picture.rgb.size(); ++i) {
    const Vec3d opponent = rgb_to_opponent(picture.rgb[i]);
    for (int channel = 0; channel < 3; ++channel) channels[channel].values[i] = opponent[channel];
  }
  const FilterWeights wide = sensitivity_kernel(blue_yellow[0], pixels_per_degree),
                      narrow = sensitivity_kernel(blue_yellow[1], pixels_per_degree);
  const double share = first_share(blue_yellow[0], wide, blue_yellow[1], narrow);
  const auto blur = [](const ImagePlane& plane, const FilterWeights& kernel) {
    return filtered(plane, sum_to_one(kernel), sum_to_one(kernel));
  };
  const ImagePlane grey = blur(channels[0], sensitivity_kernel(luminance, pixels_per_degree)),
                   red = blur(channels[1], sensitivity_kernel(red_green, pixels_per_degree)),
                   blue_wide = blur(channels[2], wide), blue_narrow = blur(channels[2], narrow);
  std::vector<Vec3d> colours;
  for (size_t i = 0; i < picture.rgb.size(); ++i) {
    const double blue = share * blue_wide.values[i] + (1 - share) * blue_narrow.values[i];
    const Vec3d rgb = opponent_to_rgb({grey.values[i], red.values[i], blue});
    const auto clamped = [](double value) { return std::clamp(value, 0.0, 1.0); };
    colours.push_back(hunt_adjusted(rgb_to_lab({clamped(rgb.x), clamped(rgb.y), clamped(rgb.z)})));
  }
  return colours;
}

/// ΔE of colours: 0 to 1, by the largest that two colours of a display can have.
double colour_difference(const Vec3d& a, const Vec3d& b) {
  static const double largest = std::pow(
      hyab(hunt_adjusted(rgb_to_lab({0, 1, 0})), hunt_adjusted(rgb_to_lab({0, 0, 1}))), colour_exponent);
  const double difference = std::pow(hyab(a, b), colour_exponent), knee = knee_share * largest;
  if (difference < knee) return knee_value * difference / knee;
  return knee_value + (1 - knee_value) * (difference - knee) / (largest - knee);
}

/// How strong edges and points of the luminance are at each pixel.
struct Features {
  std::vector<double> edges, points;
};

Features features(const Shown& picture, double pixels_per_degree) {
  const double deviation = feature_width / 2 * pixels_per_degree;  // in pixels
  const int radius = static_cast<int>(std::ceil(3 * deviation));
  const auto gauss = [&](double x) { return std::exp(-squared(x / deviation) / 2); };
  const FilterWeights across = sum_to_one(kernel_of(radius, gauss)),
                      edge = signs_to_one(kernel_of(radius, [&](double x) { return -x * gauss(x); })),
                      point = signs_to_one(kernel_of(
                          radius, [&](double x) { return (squared(x / deviation) - 1) * gauss(x); }));
  ImagePlane light(picture.width, picture.height);
  std::ranges::transform(picture.rgb, light.values.begin(),
                         [](const Vec3d& rgb) { return rgb_to_relative_xyz(rgb).y; });
  const auto strength = [&](const FilterWeights& along) {
    std::vector<double> x = filtered(light, along, across).values;
    const std::vector<double> y = filtered(light, across, along).values;
    std::ranges::transform(x, y, x.begin(), [](double a, double b) { return std::hypot(a, b); });
    return x;
  };
  return {strength(edge), strength(point)};
}

}  // namespace

double FlipMap::mean() const {
  return std::accumulate(values_.begin(), values_.end(), 0.0) / static_cast<double>(values_.size());
}

double FlipMap::max() const { return *std::ranges::max_element(values_); }

double FlipMap::quantile(double share) const {
  std::vector<float> sorted = values_;
  const double place = share * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<size_t>(place);
  std::ranges::nth_element(sorted, sorted.begin() + static_cast<std::ptrdiff_t>(below));
  const double low = sorted[below];
  if (below + 1 == sorted.size()) return low;
  const double high =
      *std::min_element(sorted.begin() + static_cast<std::ptrdiff_t>(below) + 1, sorted.end());
  return low + (place - static_cast<double>(below)) * (high - low);
}

FlipMap flip(const Film& picture, const Film& reference, double pixels_per_degree) {
  refuse_different_sizes(picture, reference);
  const Shown a = shown(picture), b = shown(reference);
  const std::vector<Vec3d> colours_a = perceived(a, pixels_per_degree),
                           colours_b = perceived(b, pixels_per_degree);
  const Features features_a = features(a, pixels_per_degree), features_b = features(b, pixels_per_degree);
  std::vector<float> values(a.rgb.size());
  for (size_t i = 0; i < values.size(); ++i) {
    const double feature = std::max(std::abs(features_a.edges[i] - features_b.edges[i]),
                                    std::abs(features_a.points[i] - features_b.points[i]));
    // An edge or a point that is there in one picture alone makes the colours' difference more.
    const double exponent = 1 - std::pow(feature / std::numbers::sqrt2, feature_exponent);
    values[i] = static_cast<float>(std::pow(colour_difference(colours_a[i], colours_b[i]), exponent));
  }
  return {a.width, a.height, std::move(values)};
}

}  // namespace raysweep
