#include "experiments/intersection/subjects.h"

#include <utility>

#include "tracer/intersect/study.h"

namespace raysweep {

namespace {

template <class T>
constexpr std::string_view precision_name = std::is_same_v<T, float> ? "float" : "double";

template <class Method, Variant variant, class T>
Hits<T> find_hits(const Trials<T>& trials) {
  std::vector<TriangleFor<Method, variant, T>> constants;
  constants.reserve(trials.triangles.size());
  for (const Triangle<T>& triangle : trials.triangles)
    constants.push_back(data_for<Method, variant>(triangle));
  return hits_of(trials, [&](const Trial<T>& trial, uint32_t triangle) {
    return solve<Method, variant, T>(trial.ray, constants[triangle], trial.t_max);
  });
}

template <class T>
struct Lists {
  std::vector<Subject<T>> subjects;
  std::vector<Inapplicable> inapplicable;

  Lists() {
    for_each_study_method([&]<class Method>(Method) {
      constexpr size_t count = variant_star<Method>().size();
      [&]<size_t... index>(std::index_sequence<index...>) { (add<Method, index>(), ...); }
      (std::make_index_sequence<count>());
    });
  }

 private:
  template <class Method, size_t index>
  void add() {
    constexpr Variant variant = variant_star<Method>()[index];
    std::string change = change_of(base_variant<Method>(), variant);
    if constexpr (applies<Method, T>(variant)) {
      subjects.push_back({Method::name, std::move(change), variant, find_hits<Method, variant, T>});
    } else {
      inapplicable.push_back(
          {Method::name, std::move(change), precision_name<T>, std::string(why_not<Method, T>(variant))});
    }
  }
};

template <class T>
const Lists<T>& lists() {
  static const Lists<T> both;
  return both;
}

}  // namespace

const std::vector<std::string_view>& study_method_names() {
  static const std::vector<std::string_view> names = [] {
    std::vector<std::string_view> list;
    for_each_study_method([&]<class Method>(Method) { list.push_back(Method::name); });
    return list;
  }();
  return names;
}

template <class T>
const std::vector<Subject<T>>& all_subjects() {
  return lists<T>().subjects;
}
template const std::vector<Subject<float>>& all_subjects();
template const std::vector<Subject<double>>& all_subjects();

const std::vector<Inapplicable>& inapplicable_subjects() {
  static const std::vector<Inapplicable> all = [] {
    std::vector<Inapplicable> list = lists<float>().inapplicable;
    for (const Inapplicable& one : lists<double>().inapplicable) list.push_back(one);
    return list;
  }();
  return all;
}

}  // namespace raysweep
