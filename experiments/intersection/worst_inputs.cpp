#include "experiments/intersection/worst_inputs.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "experiments/intersection/subjects.h"
#include "tracer/intersect/all.h"

namespace raysweep {

namespace {

template <class T>
constexpr std::string_view precision_name = std::is_same_v<T, float> ? "float" : "double";

template <class T>
std::vector<Suspect<T>> make_suspects() {
  std::vector<Suspect<T>> suspects;
  for (const Subject<T>& s : all_subjects<T>()) {
    if (s.change == "base" && s.method != "angle_sum")
      suspects.push_back({std::string(s.method), s.change, s.variant.output == Output::weights, s.find_hits});
  }
  for_each_method([&](auto method) {
    suspects.push_back({std::string(method.name), "intersect", true, [method](const Trials<T>& trials) {
                          return hits_of(trials, [&](const Trial<T>& trial, uint32_t triangle) {
                            return method.intersect(trial.ray, method.prepare(trials.triangles[triangle]));
                          });
                        }});
  });
  return suspects;
}

template <class T>
void add_numbers(std::vector<double>& numbers, const Vec3<T>& v) {
  for (int axis = 0; axis < 3; ++axis) numbers.push_back(static_cast<double>(v[axis]));
}

template <class T>
Question<T> question_of(const std::vector<double>& numbers) {
  const auto vector = [&](size_t i) {
    return Vec3<T>(static_cast<T>(numbers[i]), static_cast<T>(numbers[i + 1]),
                   static_cast<T>(numbers[i + 2]));
  };
  Question<T> question{{vector(0), vector(3)}, {}};
  for (size_t i = 6; i + 9 <= numbers.size(); i += 9)
    question.triangles.push_back({vector(i), vector(i + 3), vector(i + 6)});
  return question;
}

template <class T>
std::string verdict_of(const Question<T>& question) {
  std::string text;
  for (const Triangle<T>& triangle : question.triangles) {
    const ExactVerdict verdict = exact_verdict(question.ray, triangle);
    text += text.empty() ? "" : " ";
    text += verdict == ExactVerdict::hit ? "hit" : verdict == ExactVerdict::miss ? "miss" : "boundary";
  }
  return text;
}

std::string text_of(const Badness& badness) {
  return badness.is_wrong ? fmt::format("{:.6g}", badness.how_much) : "right";
}

template <class T>
void search_all(const SearchSettings& settings, std::vector<WorstInput>& list) {
  for (const Suspect<T>& suspect : all_suspects<T>()) {
    if (settings.what == Wrong::weight_error && !suspect.gives_weights) continue;
    const auto worst = search_worst<T>(suspect.find, settings);
    if (!worst || !worst->badness.is_wrong) continue;
    const Question<T>& question = worst->question;
    WorstInput input{suspect.method,  suspect.change,       std::string(precision_name<T>), settings.what,
                     settings.domain, verdict_of(question), text_of(worst->badness),        {}};
    add_numbers(input.numbers, question.ray.origin);
    add_numbers(input.numbers, question.ray.direction);
    for (const Triangle<T>& t : question.triangles) {
      for (const Vec3<T>& corner : {t.a, t.b, t.c}) add_numbers(input.numbers, corner);
    }
    list.push_back(std::move(input));
  }
}

template <class T>
WorstInput judged(const WorstInput& input) {
  const auto& suspects = all_suspects<T>();
  const auto suspect = std::find_if(suspects.begin(), suspects.end(), [&](const Suspect<T>& s) {
    return s.method == input.method && s.change == input.change;
  });
  if (suspect == suspects.end())
    throw std::out_of_range("unknown suspect \"" + input.method + " " + input.change + '"');
  const Question<T> question = question_of<T>(input.numbers);
  Trials<T> trials;
  for (const Triangle<T>& triangle : question.triangles) trials.add(question.ray, triangle);
  WorstInput now = input;
  now.verdict = verdict_of(question);
  now.how_wrong = text_of(badness_of(input.what, question, suspect->find(trials)));
  return now;
}

/// The place of a name in a list of them.
template <class Value, size_t count>
Value value_of(const std::array<std::string_view, count>& names, const std::string& name) {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end())
    throw std::runtime_error(
        fmt::format("\"{}\" where one of {} was expected", name, fmt::join(names, ", ")));
  return static_cast<Value>(found - names.begin());
}

WorstInput from_line(const std::string& line) {
  std::vector<std::string> cells(1);
  for (const char c : line) {
    if (c == ',') {
      cells.emplace_back();
    } else {
      cells.back() += c;
    }
  }
  constexpr size_t column_count = 8;
  if (cells.size() != column_count)
    throw std::runtime_error(fmt::format("{} columns where there should be {}", cells.size(), column_count));
  WorstInput input{cells[0],
                   cells[1],
                   cells[2],
                   value_of<Wrong>(wrong_names, cells[3]),
                   value_of<Domain>(domain_names, cells[4]),
                   cells[5],
                   cells[6],
                   {}};
  std::istringstream numbers(cells[7]);
  // Streams do not read hexadecimal numbers.
  for (std::string number; numbers >> number;) input.numbers.push_back(std::strtod(number.c_str(), nullptr));
  const size_t expected = input.what == Wrong::leak ? 24 : 15;
  if (input.numbers.size() != expected)
    throw std::runtime_error(
        fmt::format("{} numbers where there should be {}", input.numbers.size(), expected));
  return input;
}

}  // namespace

template <class T>
const std::vector<Suspect<T>>& all_suspects() {
  static const std::vector<Suspect<T>> all = make_suspects<T>();
  return all;
}
template const std::vector<Suspect<float>>& all_suspects();
template const std::vector<Suspect<double>>& all_suspects();

std::vector<WorstInput> worst_inputs(const SearchSettings& settings) {
  std::vector<WorstInput> list;
  search_all<float>(settings, list);
  search_all<double>(settings, list);
  return list;
}

WorstInput judged_anew(const WorstInput& input) {
  return input.precision == precision_name<float> ? judged<float>(input) : judged<double>(input);
}

std::string to_line(const WorstInput& input) {
  return fmt::format("{},{},{},{},{},{},{},{:a}", input.method, input.change, input.precision,
                     wrong_names[static_cast<size_t>(input.what)],
                     domain_names[static_cast<size_t>(input.domain)], input.verdict, input.how_wrong,
                     fmt::join(input.numbers, " "));
}

std::vector<WorstInput> read_worst_inputs(const std::filesystem::path& file) {
  std::ifstream in(file);
  std::string line;
  if (!std::getline(in, line) || line != worst_inputs_head)
    throw std::runtime_error(
        fmt::format("{}: its first line should be {}", file.string(), worst_inputs_head));
  std::vector<WorstInput> list;
  for (int number = 2; std::getline(in, line); ++number) {
    try {
      list.push_back(from_line(line));
    } catch (const std::runtime_error& error) {
      throw std::runtime_error(fmt::format("{}:{}: {}", file.string(), number, error.what()));
    }
  }
  return list;
}

}  // namespace raysweep
