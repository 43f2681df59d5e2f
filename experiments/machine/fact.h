// Something that is known, or the reason why it is not.
#pragma once

#include <optional>
#include <string>
#include <utility>

namespace raysweep {

/// Three states: a known value (for bool: yes or no), or unknown with the reason. Unknown is never a warning:
/// most of what is missing is missing by design, such as frequency files in a virtual machine.
template <class T>
struct Fact {
  std::optional<T> value;
  std::string reason = "not read";  // why there is no value; empty where there is

  Fact() = default;
  Fact(T known) : value(std::move(known)), reason() {}  // NOLINT: a value is a fact

  [[nodiscard]] static Fact unknown(const std::string& why) {
    Fact fact;
    fact.reason = why;
    return fact;
  }
  /// Known if there is a value, else unknown for this reason.
  [[nodiscard]] static Fact of(std::optional<T> maybe, const std::string& why_not) {
    return maybe ? Fact(*std::move(maybe)) : unknown(why_not);
  }
};

}  // namespace raysweep
