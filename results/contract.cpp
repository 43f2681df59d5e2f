#include "results/contract.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <stdexcept>

#include "results/record.h"

namespace raysweep {

namespace {

constexpr std::string_view head =
    "method,change,precision,case,seed,rays,false_misses,false_hits,missed_rays,nonfinite,t_error_class";
constexpr size_t column_count = 11;

/// "0 3 17"
template <class Number>
std::string to_text(const std::vector<Number>& levels) {
  return fmt::format("{}", fmt::join(levels, " "));
}

bool is_never(const std::vector<uint64_t>& levels) {
  return std::all_of(levels.begin(), levels.end(), [](uint64_t count) { return count == 0; });
}

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts(1);
  for (const char c : text) {
    if (c == separator) {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  return parts;
}

int64_t number_of(const std::string& text) {
  int64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || value < 0)
    throw RecordError(fmt::format("\"{}\" where a number was expected", text));
  return value;
}

template <class Number>
std::vector<Number> levels_of(const std::string& text) {
  std::vector<Number> levels;
  for (const std::string& part : split(text, ' '))
    levels.push_back(static_cast<Number>(part == "-" ? unstated : number_of(part)));
  return levels;
}

Clause clause_from(const std::string& line) {
  const std::vector<std::string> cells = split(line, ',');
  if (cells.size() != column_count)
    throw RecordError(fmt::format("{} columns where there should be {}", cells.size(), column_count));
  Clause clause{cells[0], cells[1], cells[2], cells[3], 0, 0, {}, levels_of<int>(cells[10])};
  clause.seed = static_cast<uint64_t>(number_of(cells[4]));
  clause.rays = static_cast<uint64_t>(number_of(cells[5]));
  const size_t level_count = clause.t_error_classes.size();
  for (size_t i = 0; i < clause.failures.size(); ++i) {
    const std::string& text = cells[6 + i];
    clause.failures[i] = text == "never" ? std::vector<uint64_t>(level_count) : levels_of<uint64_t>(text);
    if (clause.failures[i].size() != level_count)
      throw RecordError(fmt::format("{} for {} levels, of which t_error_class has {}", failure_names[i],
                                    clause.failures[i].size(), level_count));
  }
  return clause;
}

std::string to_line(const Clause& c) {
  std::string line =
      fmt::format("{},{},{},{},{},{}", c.method, c.change, c.precision, c.case_id, c.seed, c.rays);
  for (const auto& levels : c.failures) line.append(",").append(is_never(levels) ? "never" : to_text(levels));
  std::vector<std::string> classes;
  for (const int k : c.t_error_classes) classes.push_back(k == unstated ? "-" : std::to_string(k));
  return line + "," + to_text(classes) + "\n";
}

/// The same promise, but for errors that one of them does not give.
bool promises_the_same(const Clause& base, const Clause& changed) {
  if (base.failures != changed.failures) return false;
  for (size_t i = 0; i < base.t_error_classes.size(); ++i) {
    const int a = base.t_error_classes[i], b = changed.t_error_classes[i];
    if (a != b && a != unstated && b != unstated) return false;
  }
  return true;
}

/// All levels of one variant on one case. Throws std::invalid_argument where one lacks.
Clause clause_of_run(const AccuracyResults& results, const AccuracyRecord& of) {
  Clause clause{of.method, of.change, of.precision, of.case_id, of.seed, of.rays, {}, {}};
  const std::vector<int> levels = results.levels(of.case_id);
  for (size_t i = 0; i < levels.size(); ++i) {
    const auto* const record = levels[i] == static_cast<int>(i)
                                   ? results.find(of.method, of.change, of.precision, of.case_id, levels[i])
                                   : nullptr;
    if (!record)
      throw std::invalid_argument(fmt::format("{} {} {} {}: level {} was not run", of.method, of.change,
                                              of.precision, of.case_id, i));
    const auto counts = failure_counts(*record);
    for (size_t k = 0; k < counts.size(); ++k) clause.failures[k].push_back(counts[k]);
    clause.t_error_classes.push_back(t_error_class(*record));
  }
  return clause;
}

/// How the share b/m compares with a/n. The square root of a Poisson count has a standard deviation of 1/2,
/// whatever its mean.
Outcome compare_shares(double a, double n, double b, double m) {
  constexpr double factor = 2, deviations = 5;
  const double difference = std::sqrt(b / m) - std::sqrt(a / n);
  if (std::abs(difference) <= deviations / 2 * std::sqrt(1 / n + 1 / m)) return Outcome::kept;
  if (b * n > factor * a * m) return Outcome::broken;
  return a * m > factor * b * n ? Outcome::better : Outcome::kept;
}

Outcome compare(int64_t stated, int64_t found, int64_t slack) {
  return found > stated + slack ? Outcome::broken : found < stated - slack ? Outcome::better : Outcome::kept;
}

}  // namespace

std::array<uint64_t, 4> failure_counts(const AccuracyRecord& r) {
  return {r.false_misses, r.false_hits, r.missed_rays, r.nonfinite};
}

int t_error_class(const AccuracyRecord& record) {
  constexpr uint64_t fewest = 100;
  if (record.t_error.count < fewest) return unstated;
  int exponent = 0;
  const double digits = std::frexp(record.t_error.p99, &exponent);  // from 1/2 to below 1, or 0
  return std::max(digits == 0.5 ? exponent - 1 : exponent, 0);
}

Contract::Contract(const AccuracyResults& results) {
  for (const AccuracyRecord& record : results.records()) {
    if (index_.contains({record.method, record.change, record.precision, record.case_id})) continue;
    if (record.level != 0) continue;
    Clause clause = clause_of_run(results, record);
    const Clause* const bound_by = clause_of(record);
    if (!bound_by || !promises_the_same(*bound_by, clause)) add(std::move(clause));
  }
}

void Contract::add(Clause clause) {
  index_.emplace(Key{clause.method, clause.change, clause.precision, clause.case_id}, clauses_.size());
  clauses_.push_back(std::move(clause));
}

Contract Contract::read(const std::filesystem::path& file) {
  std::ifstream in(file);
  std::string line;
  if (!std::getline(in, line) || line != head)
    throw RecordError(fmt::format("{}: no contract: its first line should be {}", file.string(), head));
  Contract contract;
  for (int number = 2; std::getline(in, line); ++number) {
    try {
      contract.add(clause_from(line));
    } catch (const RecordError& error) {
      throw RecordError(fmt::format("{}:{}: {}", file.string(), number, error.what()));
    }
  }
  return contract;
}

const Clause* Contract::clause_of(const AccuracyRecord& record) const {
  const bool is_combined = record.change.find(',') != std::string::npos;
  if (is_combined || record.change.starts_with("contraction=")) return nullptr;
  for (const std::string& change : {record.change, std::string("base")}) {
    const auto found = index_.find({record.method, change, record.precision, record.case_id});
    if (found != index_.end()) return &clauses_[found->second];
  }
  return nullptr;
}

std::string to_csv(const Contract& contract) {
  std::string text = std::string(head) + "\n";
  for (const Clause& clause : contract.clauses()) text += to_line(clause);
  return text;
}

std::string_view name_of(Outcome outcome) {
  return outcome == Outcome::kept ? "kept" : outcome == Outcome::broken ? "broken" : "better";
}

std::vector<Judgement> judge(const AccuracyRecord& record, const Clause& clause) {
  const auto level = static_cast<size_t>(record.level);
  std::vector<Judgement> judgements;
  if (level >= clause.t_error_classes.size() || record.seed != clause.seed) return judgements;
  // The estimate that Newton's step starts from is the processor's own.
  const bool is_same_run = record.rays == clause.rays && record.variant.reciprocal == "exact";
  const auto n = static_cast<double>(clause.rays), m = static_cast<double>(record.rays);
  const auto counts = failure_counts(record);
  for (size_t i = 0; i < counts.size(); ++i) {
    const auto stated = static_cast<int64_t>(clause.failures[i][level]);
    const auto found = static_cast<int64_t>(counts[i]);
    const Outcome outcome =
        is_same_run ? compare(stated, found, 0)
                    : compare_shares(static_cast<double>(stated), n, static_cast<double>(found), m);
    judgements.push_back({failure_names[i], stated, found, outcome});
  }
  const int stated = clause.t_error_classes[level], found = t_error_class(record);
  if (stated != unstated && found != unstated)
    judgements.push_back({"t_error", stated, found, compare(stated, found, is_same_run ? 0 : 1)});
  return judgements;
}

}  // namespace raysweep
