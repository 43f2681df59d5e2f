#include "experiments/studies.h"

#include <fmt/format.h>

#include "experiments/accuracy_verb.h"
#include "experiments/config.h"
#include "experiments/errors.h"
#include "experiments/kernel_verb.h"
#include "experiments/pixels_verb.h"
#include "results/accuracy_results.h"

namespace raysweep {

namespace {

// What kinds call differently.
const std::string& name_of(const AccuracyConfig& config) { return config.settings.experiment; }
const std::string& name_of(const KernelConfig& config) { return config.experiment; }
const std::string& name_of(const PixelsConfig& config) { return config.settings.experiment; }
double budget_of(const KernelConfig& config) { return config.measure.budget_seconds; }
double budget_of(const AccuracyConfig&) { return 0; }
double budget_of(const PixelsConfig&) { return 0; }
void scale_budget_of(KernelConfig& config, double factor) { config.measure.budget_seconds *= factor; }
void scale_budget_of(AccuracyConfig&, double) {}
void scale_budget_of(PixelsConfig&, double) {}
void dry_run_of(const AccuracyConfig& config, nlohmann::json* json) { dry_run_accuracy(config, json); }
void dry_run_of(const KernelConfig& config, nlohmann::json* json) { dry_run_kernels(config, json); }
void dry_run_of(const PixelsConfig& config, nlohmann::json* json) { dry_run_pixels(config, json); }

template <class Config, class Experiment>
class StudyOf : public Study {
 public:
  using Open = Experiment (*)(const Config&, const std::filesystem::path&, const Machine&, bool);

  StudyOf(Config config, Open open) : config_(std::move(config)), open_(open) {}

  [[nodiscard]] const std::string& experiment() const override { return name_of(config_); }
  [[nodiscard]] const std::string& file() const override { return config_.file; }
  [[nodiscard]] double budget_seconds() const override { return budget_of(config_); }
  void scale_budget(double factor) override { scale_budget_of(config_, factor); }
  void dry_run(nlohmann::json* json) const override { dry_run_of(config_, json); }
  void open(const std::filesystem::path& folder, const Machine& machine, bool resume) override {
    experiment_.emplace(open_(config_, folder, machine, resume));
  }
  [[nodiscard]] int run_and_tell(nlohmann::json* json) override {
    return raysweep::run_and_tell(experiment_.value(), json);
  }

 private:
  Config config_;
  Open open_;
  std::optional<Experiment> experiment_;
};

template <class Experiment, class Config>
std::unique_ptr<Study> study_of(Config config, Experiment (*open)(const Config&, const std::filesystem::path&,
                                                                  const Machine&, bool)) {
  return std::make_unique<StudyOf<Config, Experiment>>(std::move(config), open);
}

void refuse_budget(const std::string& file, const StudyOptions& options, const char* why) {
  if (options.budget_minutes) throw RequestError(fmt::format("{}: --budget is not for {}", file, why));
}

}  // namespace

std::unique_ptr<Study> read_study(const std::string& text, const std::string& file,
                                  const StudyOptions& options, const Machine& machine) {
  if (is_accuracy(text, file, options.overrides)) {
    AccuracyConfig config = parse_accuracy_config(text, file, options.overrides);
    refuse_budget(file, options, "an accuracy experiment, of which every cell is run once");
    if (options.seed) config.settings.seed = *options.seed;
    return study_of(std::move(config), open_accuracy);
  }
  if (is_kernel(text, file, options.overrides)) {
    KernelConfig config = parse_kernel_config(text, file, options.overrides, machine.topology.processors());
    if (options.budget_minutes) config.measure.budget_seconds = *options.budget_minutes * 60;
    if (options.seed) config.measure.seed = *options.seed;
    return study_of(std::move(config), open_kernels);
  }
  if (is_pixels(text, file, options.overrides)) {
    PixelsConfig config = parse_pixels_config(text, file, options.overrides);
    refuse_budget(file, options, "a pixels experiment, which has as many rounds as its file says");
    if (options.seed) config.settings.seed = *options.seed;
    return study_of(std::move(config), open_pixels);
  }
  return nullptr;
}

bool report_study(const std::filesystem::path& folder, nlohmann::json* json,
                  const std::optional<ClaimSheet>& claims) {
  const std::string kind = run_kind(folder);
  if (kind == "accuracy") {
    report_accuracy(folder, json, claims);
  } else if (kind == "kernel") {
    report_kernels(folder, json, claims);
  } else if (kind == "pixels") {
    report_pixels(folder, json, claims);
  } else {
    return false;
  }
  return true;
}

NamedClaims read_claims_of(const std::string& file, const Machine& machine) {
  const std::string text = read_config_text(file);
  if (is_accuracy(text, file, {})) {
    const AccuracyConfig config = parse_accuracy_config(text, file, {});
    return {config.settings.experiment, config.claims.sheet};
  }
  if (is_kernel(text, file, {})) {
    const KernelConfig config = parse_kernel_config(text, file, {}, machine.topology.processors());
    return {config.experiment, config.claims.sheet};
  }
  if (is_pixels(text, file, {})) {
    const PixelsConfig config = parse_pixels_config(text, file, {});
    return {config.settings.experiment, config.claims.sheet};
  }
  const Config config = parse_config(text, file, {}, machine.size());
  return {config.experiment, config.claims.sheet};
}

}  // namespace raysweep
