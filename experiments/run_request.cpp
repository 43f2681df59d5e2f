#include "experiments/run_request.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <ctime>

#include "experiments/config_toml.h"
#include "experiments/errors.h"
#include "experiments/include_list.h"
#include "experiments/read_claims.h"

namespace raysweep {

namespace {

/// A folder for a run that was given none.
std::filesystem::path new_folder(const std::string& name) {
  const std::time_t now = std::time(nullptr);
  return std::filesystem::path("results/runs") /
         fmt::format("{}-{:%Y%m%d-%H%M%S}", name, *std::localtime(&now));
}

class RequestReader {
 public:
  RequestReader(const RunOptions& options, const Machine& machine) : options_(options), machine_(machine) {}

  RunRequest read() {
    for (const std::string& file : options_.files) try_to([&] { read_file(file); });
    if (!errors_.empty()) throw RequestError(errors_);
    refuse_two_seeds();
    return std::move(request_);
  }

 private:
  /// What is wrong with one file does not hide what is wrong with the others.
  template <class Step>
  void try_to(const Step& step) {
    try {
      step();
    } catch (const RequestError& error) {
      errors_.append(errors_.empty() ? "" : "\n").append(error.what());
    }
  }

  void read_file(const std::string& file) {
    const auto list = read_include_list(read_config_text(file), file);
    if (!list) {
      read_experiment(file, options_.budget_minutes, "");
      return;
    }
    const size_t pictures = request_.pictures.size(), studies = request_.studies.size();
    const std::filesystem::path folder =
        options_.out.empty() ? new_folder(list->name) : std::filesystem::path(options_.out);
    for (const std::string& included : list->files)
      try_to([&] { read_experiment(included, std::nullopt, folder); });
    if (options_.budget_minutes && errors_.empty())
      share_budget(*options_.budget_minutes * 60, pictures, studies);
  }

  /// `list_folder`: where the experiments of its list go; empty for one that no list includes.
  void read_experiment(const std::string& file, std::optional<double> budget_minutes,
                       const std::filesystem::path& list_folder) {
    const std::string text = read_config_text(file);
    std::vector<std::string> overrides;
    if (options_.quick) overrides = quick_overrides(read_toml(text, file, {}));
    overrides.insert(overrides.end(), options_.overrides.begin(), options_.overrides.end());
    if (auto study = read_study(text, file, {overrides, budget_minutes, options_.seed}, machine_)) {
      add_folder(study->experiment(), file, list_folder);
      request_.studies.push_back(std::move(study));
      return;
    }
    Config config = parse_config(text, file, overrides, machine_.size());
    if (budget_minutes) config.measure.budget_seconds = *budget_minutes * 60;
    if (options_.seed) config.measure.seed = *options_.seed;
    add_folder(config.experiment, file, list_folder);
    request_.pictures.push_back(std::move(config));
  }

  void add_folder(const std::string& experiment, const std::string& file,
                  const std::filesystem::path& list_folder) {
    std::filesystem::path folder = options_.out;
    if (!list_folder.empty()) {
      folder = list_folder / experiment;
    } else if (options_.out.empty()) {
      folder = new_folder(experiment);
    } else if (options_.files.size() > 1) {
      // By what was asked for: an experiment that this machine cannot answer must not move the others.
      folder /= experiment;
    }
    if (!request_.folders.emplace(experiment, folder).second) {
      throw RequestError(fmt::format("{}: experiment \"{}\" is there twice; each needs a folder of its own",
                                     file, experiment));
    }
  }

  /// `seconds` among what was read since there were so many pictures and studies, in proportion to what each
  /// has for itself. Those that have no budget take what they take.
  void share_budget(double seconds, size_t pictures, size_t studies) {
    double sum = 0;
    for (size_t i = pictures; i < request_.pictures.size(); ++i)
      sum += request_.pictures[i].measure.budget_seconds;
    for (size_t i = studies; i < request_.studies.size(); ++i) sum += request_.studies[i]->budget_seconds();
    if (sum == 0) return;
    for (size_t i = pictures; i < request_.pictures.size(); ++i)
      request_.pictures[i].measure.budget_seconds *= seconds / sum;
    for (size_t i = studies; i < request_.studies.size(); ++i)
      request_.studies[i]->scale_budget(seconds / sum);
  }

  void refuse_two_seeds() const {
    for (const Config& config : request_.pictures) {
      const Config& first = request_.pictures.front();
      // What several have is launched once for all, at one place in a round.
      if (config.measure.seed == first.measure.seed) continue;
      throw RequestError(
          fmt::format("{}: its seed is {}, that of {} is {}; experiments that run together need one: "
                      "give it by --seed",
                      config.file, config.measure.seed, first.file, first.measure.seed));
    }
  }

  const RunOptions& options_;
  const Machine& machine_;
  RunRequest request_;
  std::string errors_;
};

}  // namespace

RunRequest read_request(const RunOptions& options, const Machine& machine) {
  return RequestReader(options, machine).read();
}

}  // namespace raysweep
