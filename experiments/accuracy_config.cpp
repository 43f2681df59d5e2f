#include "experiments/accuracy_config.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "experiments/claim_scopes.h"
#include "experiments/config_toml.h"
#include "experiments/read_claims.h"
#include "experiments/toml_reader.h"
#include "schedulers/binding.h"

namespace raysweep {

namespace {

constexpr int most_rays = 10'000'000;  // of one cell: with all that is known of them they take 4 GB a thread
constexpr int most_threads = 1024;     // as of pictures

std::vector<std::string_view> case_ids() {
  std::vector<std::string_view> ids;
  for (const Case& one : all_cases()) ids.push_back(one.id);
  return ids;
}

class AccuracyParser : public TomlReader {
 public:
  explicit AccuracyParser(AccuracyConfig& config) : TomlReader(config.file), config_(config) {}

  void read(const toml::table& root) {
    const ConfigHead of_all = head(root, {"sweep", "measure"});
    config_.settings.experiment = of_all.experiment;
    config_.title = of_all.title;
    const toml::table none;
    const toml::table* const sweep = section(root, "sweep");
    read_sweep(sweep ? *sweep : none);
    const toml::table* const measure = section(root, "measure");
    read_measure(measure ? *measure : none);
  }

 private:
  void read_sweep(const toml::table& sweep) {
    check_keys(sweep, "sweep.", {"method", "precision", "case", "variant"});
    config_.methods = names_or_all(sweep, "method", study_method_names());
    config_.cases = names_or_all(sweep, "case", case_ids());
    for (const std::string& name : names_or_all(sweep, "precision", {"float", "double"}))
      config_.precisions.push_back(name == "float" ? Precision::float_precision
                                                   : Precision::double_precision);
    config_.variants =
        read_variants(*this, sweep, "variant",
                      changes_of(run_subjects<float>(), run_subjects<double>(), inapplicable_here()));
  }

  void read_measure(const toml::table& measure) {
    check_keys(measure, "measure.", {"trials", "seed", "threads"});
    config_.settings.ray_count = static_cast<size_t>(integer_or(measure, "trials", 10'000, 1, most_rays));
    config_.settings.seed = static_cast<uint64_t>(integer_or(measure, "seed", 1, 0, 1 << 30));
    if (measure.contains("threads")) config_.threads = integer_or(measure, "threads", 1, 1, most_threads);
  }

  AccuracyConfig& config_;
};

/// Indices of the subjects that are asked for, method by method as the config lists them.
template <class T>
std::vector<size_t> chosen_subjects(const AccuracyConfig& config) {
  std::vector<size_t> chosen;
  const auto& subjects = run_subjects<T>();
  for (const std::string& method : config.methods) {
    for (size_t i = 0; i < subjects.size(); ++i) {
      if (subjects[i].method == method && config.variants.takes(subjects[i].change, subjects[i].combines))
        chosen.push_back(i);
    }
  }
  return chosen;
}

}  // namespace

bool is_accuracy(const std::string& text, const std::string& file,
                 const std::vector<std::string>& overrides) {
  return read_toml(text, file, overrides)["kind"].value<std::string>() == "accuracy";
}

AccuracyConfig parse_accuracy_config(const std::string& text, const std::string& file,
                                     const std::vector<std::string>& overrides) {
  AccuracyConfig config;
  config.file = file;
  config.text = text;
  const toml::table root = read_toml(text, file, overrides);
  if (!overrides.empty()) config.text = to_text(root);
  AccuracyParser parser(config);
  parser.read(root);
  config.claims = read_claims(parser, root, {text, overrides}, claim_scope(config));
  parser.refuse_errors();
  return config;
}

size_t AccuracyPlan::cell_count() const {
  size_t count = 0;
  for (const AccuracyBatch& batch : batches) count += batch.subjects.size();
  return count;
}

AccuracyPlan make_plan(const AccuracyConfig& config) {
  const size_t threads =
      config.threads > 0 ? static_cast<size_t>(config.threads) : allowed_processors().size();
  AccuracyPlan plan{config.title, config.settings, threads, config.claims.sheet, {}, {}};
  const auto of_floats = chosen_subjects<float>(config), of_doubles = chosen_subjects<double>(config);
  for (const std::string& id : config.cases) {
    const Case& one = case_of(id);
    for (size_t level = 0; level < one.difficulties.size(); ++level) {
      for (const Precision precision : config.precisions) {
        plan.batches.push_back(
            {&one, level, precision, precision == Precision::float_precision ? of_floats : of_doubles});
      }
    }
  }
  plan.left_out = left_out_of(inapplicable_here(), config.variants, config.methods, config.precisions);
  return plan;
}

nlohmann::json to_json(const AccuracyPlan& plan) {
  nlohmann::json json{{"experiment", plan.settings.experiment},
                      {"title", plan.title},
                      {"kind", "accuracy"},
                      {"seed", plan.settings.seed},
                      {"trials", plan.settings.ray_count},
                      {"cells", nlohmann::json::array()},
                      {"left_out", left_out_as_json(plan.left_out)}};
  for (const AccuracyBatch& batch : plan.batches) {
    for (const size_t subject : batch.subjects) json["cells"].push_back(cell_key(batch, subject));
  }
  add_to_plan(json, plan.sheet);
  return json;
}

}  // namespace raysweep
