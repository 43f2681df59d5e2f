// One [[claim]] of a config.
#pragma once

#include <set>
#include <string>

#include "experiments/claim_values.h"
#include "results/claims/claim.h"

namespace raysweep {

/// Collects what is wrong in `reader`; of all claims of a config, so that it knows ids that are there twice.
class ClaimParser {
 public:
  ClaimParser(TomlReader& reader, ClaimValues& values, const ClaimScope& scope)
      : reader_(reader), values_(values), scope_(scope) {}

  [[nodiscard]] Claim read(const toml::table& from);

 private:
  void fail(const char* key, const std::string& sentence);
  std::string text(const char* key, const std::string& otherwise = {});
  void read_texts(Claim& claim);
  void read_choice(Claim& claim);
  void read_conditions(Claim& claim);
  void read_holds(Claim& claim);
  void read_ratio(Claim& claim);
  void read_key(Claim& claim);
  void read_linear(Claim& claim);
  std::string value_of_key(const Claim& claim, const char* name);
  void read_range_of_key(Claim& claim);
  void read_expectation(Claim& claim);
  void refuse_missing_expectation(const Claim& claim);

  TomlReader& reader_;
  ClaimValues& values_;
  const ClaimScope& scope_;
  const toml::table* from_ = nullptr;
  std::set<std::string> ids_;
};

}  // namespace raysweep
