#include "experiments/kernels/expression_templates.h"
#include "experiments/kernels/highway_loops.h"

namespace raysweep {

namespace {

class HighwayExpressions : public SmallPass {
 public:
  HighwayExpressions(uint64_t evaluations, uint64_t seed)
      : evaluations_(evaluations), operands_(random_operands(seed)) {}

  [[nodiscard]] uint64_t operations() const override { return evaluations_; }
  double run() override {
    evaluate(evaluations_);
    return static_cast<double>(result_[0]);
  }
  [[nodiscard]] std::string why_wrong() override {
    std::vector<FourFloats> results;
    for (uint64_t i = 1; i <= operand_count; ++i) {
      evaluate(i);
      results.push_back(result_);
    }
    return why_results_wrong(operands_, results);
  }
  [[nodiscard]] std::optional<TickRecord> ticks() override {
    CycleTimer timer;
    highway_evaluate_timed(floats(), operand_count, evaluations_, result_.data(), timer);
    return tick_record(timer);
  }

 private:
  [[nodiscard]] const float* floats() const { return operands_[0][0].data(); }
  void evaluate(uint64_t count) { highway_evaluate(floats(), operand_count, count, result_.data()); }

  uint64_t evaluations_;
  std::vector<Operands> operands_;
  FourFloats result_{};
};

}  // namespace

std::unique_ptr<SmallPass> highway_expressions(uint64_t evaluations, uint64_t seed) {
  return std::make_unique<HighwayExpressions>(evaluations, seed);
}

}  // namespace raysweep
