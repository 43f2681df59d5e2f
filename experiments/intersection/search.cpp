#include "experiments/intersection/search.h"

#include <cmath>

#include "experiments/intersection/draw.h"

namespace raysweep {

namespace {

/// A ray and corners that triangles share: what moves when one number does.
template <class T>
struct Place {
  std::vector<Vec3<T>> vectors;              // the ray's origin and direction, then corners
  std::vector<std::array<size_t, 3>> faces;  // indices of corners among `vectors`

  [[nodiscard]] Question<T> question() const {
    Question<T> result{{vectors[0], vectors[1]}, {}};
    for (const auto& f : faces) result.triangles.push_back({vectors[f[0]], vectors[f[1]], vectors[f[2]]});
    return result;
  }
};

template <class T>
Place<T> place_of(const Question<T>& question) {
  Place<T> place{{question.ray.origin, question.ray.direction}, {}};
  for (const Triangle<T>& t : question.triangles) {
    std::array<size_t, 3> face{};
    size_t side = 0;
    for (const Vec3<T>& corner : {t.a, t.b, t.c}) {
      size_t i = 2;
      while (i < place.vectors.size() && !(place.vectors[i] == corner)) ++i;
      if (i == place.vectors.size()) place.vectors.push_back(corner);
      face[side++] = i;
    }
    place.faces.push_back(face);
  }
  return place;
}

template <class T>
T& coordinate(Vec3<T>& v, size_t axis) {
  return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
}

/// By ± 2^k ulp: from the last digit to twice the number itself.
template <class T>
void nudge(Place<T>& place, Random& random) {
  constexpr int digits = std::numeric_limits<T>::digits;
  Vec3<T>& v = place.vectors[random.index(place.vectors.size())];
  T& number = coordinate(v, random.index(3));
  // Zeros are moved as the other numbers of their vector.
  const T size = number != 0 ? std::abs(number) : max_abs(v);
  if (size == 0 || !std::isfinite(size)) return;
  const int ulp = std::ilogb(size) - digits + 1, by = static_cast<int>(random.index(digits + 1));
  number += static_cast<T>(random.sign() * std::ldexp(1.0, ulp + by));
}

template <class T>
void swap_axes(Place<T>& place, Random& random) {
  const size_t first = random.index(3), second = (first + 1 + random.index(2)) % 3;
  for (Vec3<T>& v : place.vectors) std::swap(coordinate(v, first), coordinate(v, second));
}

template <class T>
void swap_corners(Place<T>& place, Random& random) {
  auto& face = place.faces[random.index(place.faces.size())];
  const size_t first = random.index(3);
  std::swap(face[first], face[(first + 1) % 3]);
}

/// One number, the direction, or all places, by 2, 4, 8 or their inverses.
template <class T>
void scale(Place<T>& place, Random& random) {
  const int exponent = static_cast<int>(random.sign()) * static_cast<int>(1 + random.index(3));
  const T factor = static_cast<T>(std::ldexp(1.0, exponent));
  const size_t what = random.index(3);
  if (what == 0) {
    coordinate(place.vectors[random.index(place.vectors.size())], random.index(3)) *= factor;
  } else {
    for (size_t i = 0; i < place.vectors.size(); ++i) {
      if ((i == 1) == (what == 1)) place.vectors[i] = place.vectors[i] * factor;
    }
  }
}

template <class T>
Place<T> mutant_of(const Place<T>& place, Random& random) {
  Place<T> mutant = place;
  const size_t move = random.index(16);
  if (move == 0) {
    swap_axes(mutant, random);
  } else if (move == 1) {
    swap_corners(mutant, random);
  } else if (move == 2) {
    scale(mutant, random);
  } else {
    for (size_t i = 0; i <= move % 3; ++i) nudge(mutant, random);
  }
  return mutant;
}

/// How bad the method is on each of `places`; all are asked at once.
template <class T>
std::vector<Badness> badnesses_of(const std::vector<Place<T>>& places, const Finder<T>& finder,
                                  const SearchSettings& settings) {
  Trials<T> trials;
  std::vector<Question<T>> questions;
  for (const Place<T>& place : places) {
    questions.push_back(place.question());
    for (const Triangle<T>& triangle : questions.back().triangles) trials.add(questions.back().ray, triangle);
  }
  const Hits<T> hits = finder(trials);
  std::vector<Badness> badnesses;
  auto next = hits.begin();
  for (const Question<T>& question : questions) {
    const auto end = next + static_cast<std::ptrdiff_t>(question.triangles.size());
    badnesses.push_back(is_in(settings.domain, question)
                            ? badness_of(settings.what, question, Hits<T>(next, end))
                            : not_asked());
    next = end;
  }
  return badnesses;
}

/// Of a ray of a case the first candidate, or the first two that share an edge; none if there are no such.
template <class T>
std::optional<Question<T>> question_of(const Trials<T>& trials, const Trial<T>& trial, Wrong what) {
  const auto candidate = [&](size_t i) { return trials.triangles[trials.candidates[trial.first + i]]; };
  if (what != Wrong::leak) {
    if (trial.count == 0) return {};
    return Question<T>{trial.ray, {candidate(0)}};
  }
  constexpr size_t vectors = 2 + 4;  // of two triangles with two corners in common
  for (size_t i = 0; i < trial.count; ++i) {
    for (size_t k = i + 1; k < trial.count; ++k) {
      Question<T> question{trial.ray, {candidate(i), candidate(k)}};
      if (place_of(question).vectors.size() == vectors) return question;
    }
  }
  return {};
}

/// A ray of any case at any difficulty that is in the domain and asks for what is looked for.
template <class T>
std::optional<Place<T>> start_of(const Finder<T>& finder, const SearchSettings& settings, Random& random) {
  constexpr size_t most_draws = 400, rays = 4;
  const auto& cases = all_cases();
  for (size_t draw = 0; draw < most_draws; ++draw) {
    const Case& one = cases[random.index(cases.size())];
    const double difficulty = one.difficulties[random.index(one.difficulties.size())];
    const Trials<T> trials = one.make<T>(difficulty, random.index(1 << 20), rays);
    for (const Trial<T>& trial : trials.rays) {
      const auto question = question_of(trials, trial, settings.what);
      if (!question || !is_in(settings.domain, *question)) continue;
      Place<T> place = place_of(*question);
      if (badnesses_of<T>({place}, finder, settings)[0] > not_asked()) return place;
    }
  }
  return {};
}

template <class T>
Worst<T> climb(Place<T> place, const Finder<T>& finder, const SearchSettings& settings, Random& random) {
  Badness badness = badnesses_of<T>({place}, finder, settings)[0];
  size_t in_vain = 0;
  for (size_t step = 0; step < settings.most_steps && in_vain < settings.patience; ++step, ++in_vain) {
    std::vector<Place<T>> mutants;
    while (mutants.size() < settings.mutants) mutants.push_back(mutant_of(place, random));
    const std::vector<Badness> badnesses = badnesses_of(mutants, finder, settings);
    const auto worst = std::max_element(badnesses.begin(), badnesses.end());
    if (*worst > badness) in_vain = 0;
    // As bad is good enough to go on from: that leads across what is level.
    if (!(*worst < badness)) {
      badness = *worst;
      place = mutants[static_cast<size_t>(worst - badnesses.begin())];
    }
  }
  return {place.question(), badness};
}

}  // namespace

template <class T>
std::optional<Worst<T>> search_worst(const Finder<T>& finder, const SearchSettings& settings) {
  Random random(settings.seed);
  std::optional<Worst<T>> worst;
  for (size_t i = 0; i < settings.starts; ++i) {
    const auto start = start_of(finder, settings, random);
    if (!start) break;
    Worst<T> found = climb(*start, finder, settings, random);
    if (!worst || found.badness > worst->badness) worst = std::move(found);
  }
  return worst;
}

template std::optional<Worst<float>> search_worst(const Finder<float>&, const SearchSettings&);
template std::optional<Worst<double>> search_worst(const Finder<double>&, const SearchSettings&);

}  // namespace raysweep
