// Experiments that run in this process, one after the other: the kinds accuracy, kernel and pixels.
#pragma once

#include <filesystem>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "experiments/machine/machine.h"
#include "results/claims/claim_sheet.h"

namespace raysweep {

/// What the command line says of a config.
struct StudyOptions {
  std::vector<std::string> overrides;
  std::optional<double> budget_minutes;
  std::optional<uint64_t> seed;
};

/// Each of its functions prints for people, or, where `json` is not null, appends its document there instead.
class Study {
 public:
  Study() = default;
  virtual ~Study() = default;
  Study(const Study&) = delete;
  Study& operator=(const Study&) = delete;

  [[nodiscard]] virtual const std::string& experiment() const = 0;
  [[nodiscard]] virtual const std::string& file() const = 0;
  /// Seconds that it may take; 0 where it runs each cell as often as its file says.
  [[nodiscard]] virtual double budget_seconds() const = 0;
  virtual void scale_budget(double factor) = 0;
  /// What would be run, and how long it might take.
  virtual void dry_run(nlohmann::json* json) const = 0;
  /// Makes the folder, or takes it up. Throws RequestError as RunFiles.
  virtual void open(const std::filesystem::path& folder, const Machine& machine, bool resume) = 0;
  /// Once it is open: runs, then tells with tables; writes these into the folder. The exit code.
  [[nodiscard]] virtual int run_and_tell(nlohmann::json* json) = 0;
};

/// The study that a config describes; null where it is of pictures. Throws RequestError with one line per
/// error.
[[nodiscard]] std::unique_ptr<Study> read_study(const std::string& text, const std::string& file,
                                                const StudyOptions& options, const Machine& machine);

/// The tables of a study's folder anew, judged by `claims`, or those of its plan; false where it holds a run
/// of pictures. Throws RecordError where it cannot be read.
[[nodiscard]] bool report_study(const std::filesystem::path& folder, nlohmann::json* json,
                                const std::optional<ClaimSheet>& claims);

/// A config's claims, of whatever kind, with the name of its experiment. Throws RequestError with one line
/// per error.
struct NamedClaims {
  std::string experiment;
  ClaimSheet sheet;
};
[[nodiscard]] NamedClaims read_claims_of(const std::string& file, const Machine& machine);

}  // namespace raysweep
