#include "results/claims/expression.h"

#include <fmt/format.h>
#include <mpParser.h>

#include <cmath>
#include <regex>

namespace raysweep {

bool mentions_machine(const std::string& text) {
  static const std::regex name(R"(\b(cores|pus|smt)\b)");
  // Most texts are names of values, and there are many: one glance is enough for them.
  const auto has = [&](const char* word) { return text.find(word) != std::string::npos; };
  return (has("cores") || has("pus") || has("smt")) && std::regex_search(text, name);
}

double evaluate(const std::string& text, const MachineCounts& machine) {
  if (mentions_machine(text) && !machine.is_known())
    throw ExpressionError(fmt::format("\"{}\" needs a machine whose cores are known", text));
  double value = 0;
  try {
    mup::ParserX parser;
    // Constants, so that "cores = 6" is refused and not an assignment.
    parser.DefineConst("cores", static_cast<mup::float_type>(machine.cores));
    parser.DefineConst("pus", static_cast<mup::float_type>(machine.pus));
    parser.DefineConst("smt", machine.pus > machine.cores);
    parser.SetExpr(text);
    const mup::Value result = parser.Eval();
    value = result.GetType() == 'b' ? static_cast<double>(result.GetBool()) : result.GetFloat();
  } catch (const mup::ParserError& error) {
    throw ExpressionError(
        fmt::format("\"{}\" is no formula of cores, pus and smt: {}", text, error.GetMsg()));
  }
  if (!std::isfinite(value)) throw ExpressionError(fmt::format("\"{}\" comes to no number", text));
  return value;
}

}  // namespace raysweep
