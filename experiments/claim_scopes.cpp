#include "experiments/claim_scopes.h"

#include "results/claims/measured_cells.h"

namespace raysweep {

namespace {

ClaimScope scope_of_kind(const std::string& kind) {
  ClaimScope scope{quantities_of(kind), {}};
  for (const std::string& name : factors_of(kind)) scope.factors[name] = {};
  return scope;
}

/// Kernels without rays have the factors of their sweep.
ClaimScope scope_of(const std::vector<SmallKernelSweep>& sweeps) {
  ClaimScope scope{quantities_of("kernel"), {{"statistic", tick_statistics()}}};
  for (const SmallKernelSweep& sweep : sweeps) {
    scope.factors["kernel"].emplace_back(sweep.kernel->name);
    for (size_t i = 0; i < sweep.values.size(); ++i)
      scope.factors[std::string(sweep.kernel->factors[i].name)] = sweep.values[i];
  }
  return scope;
}

std::vector<std::string> names_of(const std::vector<Precision>& precisions) {
  std::vector<std::string> names;
  for (const Precision precision : precisions) names.emplace_back(name_of(precision));
  return names;
}

}  // namespace

ClaimScope claim_scope(const Config& config) {
  ClaimScope scope = scope_of_kind("picture");
  if (!config.modes.empty()) scope.factors["mode"] = config.modes;
  for (const SweepAxis& axis : config.axes) {
    for (size_t i = 0; i < axis.names.size(); ++i) {
      for (const auto& point : axis.points) scope.factors[axis.names[i]].push_back(point[i]);
    }
  }
  // The bases that every run has.
  if (auto& schedulers = scope.factors["scheduler"]; !schedulers.empty()) schedulers.push_back("serial");
  // Written as they are asked for, recorded as they are found.
  for (const char* name : {"isa", "runtime", "lights", "environment", "pin"}) scope.factors[name].clear();
  return scope;
}

ClaimScope claim_scope(const KernelConfig& config) {
  if (!config.small.empty()) return scope_of(config.small);
  ClaimScope scope = scope_of_kind("kernel");
  scope.factors["method"] = config.methods;
  scope.factors["protocol"] = config.protocols;
  if (config.variants.is_list()) scope.factors["change"] = config.variants.changes;
  scope.factors["precision"] = names_of(config.precisions);
  scope.factors["scheduler"] = config.schedulers;
  return scope;
}

ClaimScope claim_scope(const AccuracyConfig& config) {
  ClaimScope scope = scope_of_kind("accuracy");
  scope.factors["method"] = config.methods;
  scope.factors["case"] = config.cases;
  if (config.variants.is_list()) scope.factors["change"] = config.variants.changes;
  scope.factors["precision"] = names_of(config.precisions);
  return scope;
}

ClaimScope claim_scope(const PixelsConfig& config) {
  ClaimScope scope = scope_of_kind("pixels");
  for (const PixelsGroup& group : config.groups) {
    scope.factors["scene"].push_back(group.scene);
    scope.factors["mode"].push_back(group.mode);
    for (const PixelsSubject& subject : group.subjects) {
      scope.factors["core"].push_back(subject.core);
      scope.factors["method"].push_back(subject.method);
      scope.factors["precision"].push_back(subject.precision);
      if (!subject.pattern.empty()) scope.factors["pattern"].push_back(subject.pattern);
    }
  }
  return scope;
}

}  // namespace raysweep
