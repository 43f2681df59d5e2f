// What is timed beside the study's tests: small pieces of code of which a paper says what they cost.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "results/kernel_record.h"

namespace raysweep {

/// What a kernel can be asked for.
struct KernelFactor {
  std::string_view name;
  std::vector<std::string_view> names{};  // all that it can be; empty where it is a number
  // Of a number:
  double low = 0, high = 0, step = 1;
  std::vector<double> usual{};  // without the key
};

/// One value of each factor, by the factor's name.
using FactorValues = std::map<std::string, std::string>;

/// Whole numbers as such, others by six digits: "1000000", "0.0125".
[[nodiscard]] std::string factor_text(double number);
[[nodiscard]] double number_of(const FactorValues& values, const std::string& factor);

/// A kernel with its data laid out.
class SmallPass {
 public:
  SmallPass() = default;
  virtual ~SmallPass() = default;
  SmallPass(const SmallPass&) = delete;
  SmallPass& operator=(const SmallPass&) = delete;

  [[nodiscard]] virtual uint64_t operations() const = 0;  // of a pass
  /// All of them once: what is timed. The number depends on what was computed.
  virtual double run() = 0;
  /// Compares what is computed with what it should be, bit for bit: a clause; empty if nothing is wrong.
  [[nodiscard]] virtual std::string why_wrong() = 0;
  /// Whether each pass is to find caches and predictors as `disturb` leaves them.
  [[nodiscard]] virtual bool is_disturbed() const { return false; }
  virtual void disturb() {}
  /// A pass of which every operation is timed by itself; none where those are not asked for.
  [[nodiscard]] virtual std::optional<TickRecord> ticks() { return {}; }
};

struct SmallKernel {
  std::string_view name, summary, operation;  // "evaluation": of what times are told
  std::vector<KernelFactor> factors;          // the first is what is compared
  /// Why it cannot be timed here; empty if it can.
  std::string (*why_not)(const FactorValues& values);
  std::unique_ptr<SmallPass> (*prepare)(const FactorValues& values, uint64_t seed);
  /// What a pass takes, roughly, with its share of what is done beside: for estimates.
  double (*rough_seconds)(const FactorValues& values);
};

/// The one list of them.
[[nodiscard]] const std::vector<SmallKernel>& all_small_kernels();

/// Null for an unknown name.
[[nodiscard]] const SmallKernel* find_small_kernel(std::string_view name);

// One each of their files.
[[nodiscard]] SmallKernel branches_kernel();
[[nodiscard]] SmallKernel dot_products_kernel();
[[nodiscard]] SmallKernel expression_templates_kernel();
[[nodiscard]] SmallKernel virtual_calls_kernel();

}  // namespace raysweep
