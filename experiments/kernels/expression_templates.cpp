#include "experiments/kernels/expression_templates.h"

#include <fmt/format.h>

#include <Eigen/Core>
#include <bit>

#include "experiments/kernels/keep.h"
#include "results/statistics/random.h"

namespace raysweep {

namespace {

/// How a type is made of four floats and told as such, and how an evaluation leaves its result. Here for
/// those that are made of a list of floats.
template <class V>
struct Holder {
  using Type = V;
  static V make(const FourFloats& x) { return V{x[0], x[1], x[2], x[3]}; }
  static FourFloats floats(const V& v) { return std::bit_cast<FourFloats>(v); }
  static void evaluate(V& r, const V& a, const V& b, const V& c, const V& d, const V& e) {
    r = expression(a, b, c, d, e);
  }
};

struct EigenHolder : Holder<Eigen::Array4f> {
  static FourFloats floats(const Type& v) { return {v[0], v[1], v[2], v[3]}; }
  /// Not by `expression`: what Eigen's operators hand out refers to values that would be gone.
  static void evaluate(Type& r, const Type& a, const Type& b, const Type& c, const Type& d, const Type& e) {
    r = (a + b) * c - d * e;
  }
};

struct LazyHolder : Holder<LazyVec4> {
  static LazyVec4 make(const FourFloats& x) { return LazyVec4(x); }
  static FourFloats floats(const LazyVec4& v) {
    return {v.lanes()[0], v.lanes()[1], v.lanes()[2], v.lanes()[3]};
  }
};

struct ValarrayHolder : Holder<ValarrayVec4> {
  static ValarrayVec4 make(const FourFloats& x) { return {std::valarray<float>(x.data(), x.size())}; }
  static FourFloats floats(const ValarrayVec4& v) { return {v.lanes[0], v.lanes[1], v.lanes[2], v.lanes[3]}; }
};

/// std::valarray as libstdc++ has it, with expression templates of its own: memory for the result alone.
struct LazyValarrayHolder : ValarrayHolder {
  static void evaluate(Type& r, const Type& a, const Type& b, const Type& c, const Type& d, const Type& e) {
    r.lanes = (a.lanes + b.lanes) * c.lanes - d.lanes * e.lanes;
  }
};

template <class Holder>
class ExpressionPass : public SmallPass {
 public:
  ExpressionPass(uint64_t evaluations, uint64_t seed)
      : evaluations_(evaluations), operands_(random_operands(seed)) {
    for (const Operands& o : operands_)
      held_.push_back({Holder::make(o[0]), Holder::make(o[1]), Holder::make(o[2]), Holder::make(o[3]),
                       Holder::make(o[4])});
  }

  [[nodiscard]] uint64_t operations() const override { return evaluations_; }
  double run() override {
    auto result = Holder::make({});
    for (uint64_t i = 0; i < evaluations_; ++i) evaluate(result, i);
    return static_cast<double>(Holder::floats(result)[0]);
  }
  [[nodiscard]] std::string why_wrong() override {
    std::vector<FourFloats> results;
    auto result = Holder::make({});
    for (uint64_t i = 0; i < operand_count; ++i) {
      evaluate(result, i);
      results.push_back(Holder::floats(result));
    }
    return why_results_wrong(operands_, results);
  }
  [[nodiscard]] std::optional<TickRecord> ticks() override {
    auto result = Holder::make({});
    CycleTimer timer;
    for (uint64_t i = 0; i < evaluations_; ++i) {
      timer.begin();
      evaluate(result, i);
      timer.end();
    }
    return tick_record(timer);
  }

 private:
  void evaluate(typename Holder::Type& result, uint64_t i) {
    const auto& [a, b, c, d, e] = held_[i % operand_count];
    Holder::evaluate(result, a, b, c, d, e);
    keep(result);
  }

  uint64_t evaluations_;
  std::vector<Operands> operands_;
  std::vector<std::array<typename Holder::Type, 5>> held_;
};

/// An evaluation, and reading a clock around it once in each record.
double rough_seconds_of_expressions(const FactorValues& values) {
  const double nanoseconds = values.at("vector") == "valarray" ? 120 : 15;
  return number_of(values, "iterations") * nanoseconds * 1e-9;
}

std::unique_ptr<SmallPass> prepare_expressions(const FactorValues& values, uint64_t seed) {
  const auto count = static_cast<uint64_t>(number_of(values, "iterations"));
  const std::string& vector = values.at("vector");
  if (vector == "valarray") return std::make_unique<ExpressionPass<ValarrayHolder>>(count, seed);
  if (vector == "valarray_lazy") return std::make_unique<ExpressionPass<LazyValarrayHolder>>(count, seed);
  if (vector == "struct") return std::make_unique<ExpressionPass<Holder<StructVec4>>>(count, seed);
  if (vector == "eigen") return std::make_unique<ExpressionPass<EigenHolder>>(count, seed);
  if (vector == "highway") return highway_expressions(count, seed);
  return std::make_unique<ExpressionPass<LazyHolder>>(count, seed);
}

}  // namespace

std::vector<Operands> random_operands(uint64_t seed) {
  Random random(seed);
  std::vector<Operands> list(operand_count);
  for (Operands& operands : list) {
    for (FourFloats& four : operands) {
      // In [−1, 1): far from what overflows, and from the numbers that processors are slow with.
      for (float& x : four)
        x = static_cast<float>(static_cast<double>(random.index(1U << 24U)) / (1U << 23U) - 1);
    }
  }
  return list;
}

FourFloats expected_of(const Operands& operands) {
  const auto& [a, b, c, d, e] = operands;
  FourFloats result{};
  for (size_t i = 0; i < result.size(); ++i) result[i] = expression(a[i], b[i], c[i], d[i], e[i]);
  return result;
}

std::string why_results_wrong(const std::vector<Operands>& operands, const std::vector<FourFloats>& results) {
  using Bits = std::array<uint32_t, 4>;
  for (size_t i = 0; i < operands.size(); ++i) {
    const FourFloats expected = expected_of(operands[i]);
    if (std::bit_cast<Bits>(results[i]) != std::bit_cast<Bits>(expected))
      return fmt::format("evaluation {} is {}, where {} is right", i, fmt::join(results[i], " "),
                         fmt::join(expected, " "));
  }
  return {};
}

TickRecord tick_record(const CycleTimer& timer) {
  using Mode = CycleTimer::Mode;
  return {timer.ticks(Mode::min), timer.ticks(Mode::avg), timer.ticks(Mode::max), timer.ticks(Mode::sum)};
}

SmallKernel expression_templates_kernel() {
  return {"expression_templates",
          "(a + b) · c − d · e of four floats each, evaluated one after the other",
          "evaluation",
          {{"vector", {"expression_templates", "valarray", "valarray_lazy", "struct", "eigen", "highway"}},
           {"iterations", {}, 1, 1e7, 1, {10, 100, 1000, 1e4, 1e5, 1e6, 1e7}}},
          [](const FactorValues&) { return std::string(); },
          prepare_expressions,
          rough_seconds_of_expressions};
}

}  // namespace raysweep
