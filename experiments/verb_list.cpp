#include <fmt/core.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "experiments/intersection/case.h"
#include "experiments/intersection/tracer_cases.h"
#include "experiments/item.h"
#include "experiments/verbs.h"
#include "schedulers/placement.h"
#include "schedulers/registry.h"
#include "tracer/scene/scenes.h"
#include "tracer/settings.h"
#include "tracer/wide/isa.h"

namespace raysweep {

namespace {

nlohmann::json entry(std::string_view name, std::string_view summary, const std::string& reason = {}) {
  return {{"name", name}, {"summary", summary}, {"available", reason.empty()}, {"reason", reason}};
}

nlohmann::json list_schedulers() {
  nlohmann::json list;
  for (const SchedulerInfo& s : all_schedulers())
    list.push_back(entry(s.name, s.summary, why_unavailable(s)));
  return list;
}

nlohmann::json list_runtimes() {
  nlohmann::json list;
  for (const RuntimeInfo& runtime : all_runtimes()) {
    const ModuleReport& report = module_report(std::string(runtime.name));
    const std::string summary = report.problem.empty()
                                    ? fmt::format("{}, {}", report.version, report.library.file)
                                    : std::string(runtime.needs);
    list.push_back(entry(runtime.name, summary, report.problem));
    list.back()["build_id"] = report.library.build_id;
  }
  return list;
}

/// Anything with a name and a summary.
template <class List>
nlohmann::json list_named(const List& items) {
  nlohmann::json list;
  for (const auto& item : items) list.push_back(entry(item.name, item.summary));
  return list;
}

nlohmann::json list_scenes() {
  nlohmann::json list;
  for (const BuiltInScene& scene : built_in_scenes()) {
    list.push_back(entry(scene.name, scene.summary));
    list.back()["triangles"] = scene.triangle_count;
    list.back()["spheres"] = scene.sphere_count;
    list.back()["planes"] = scene.plane_count;
    list.back()["lights"] = scene.light_count;
  }
  list.push_back(
      entry("FILE.toml",
            "a scene described in TOML: tracer/scene/README.md tells how; experiments/scenes has some"));
  list.push_back(
      entry("FILE", "a mesh: OBJ, PLY, STL, glTF and what else Assimp reads", why_no_mesh_files()));
  return list;
}

nlohmann::json list_modes() {
  nlohmann::json list;
  for (const Mode& m : modes()) {
    list.push_back(entry(m.name, fmt::format("{} x {}, {} subpixels, depth {}, {} lights", m.width, m.height,
                                             m.subpixels, m.depth, m.lights)));
  }
  return list;
}

/// The configs of this checkout, with the question in their first line.
nlohmann::json list_experiments() {
  nlohmann::json list = nlohmann::json::array();
  std::error_code error;
  std::vector<std::filesystem::path> files;
  for (const auto& file : std::filesystem::directory_iterator(RAYSWEEP_CONFIG_DIR, error)) {
    if (file.path().extension() == ".toml") files.push_back(file.path());
  }
  std::ranges::sort(files);
  for (const auto& file : files) {
    std::ifstream in(file);
    std::string question;
    std::getline(in, question);
    list.push_back(entry(std::filesystem::proximate(file, error).string(),
                         question.substr(std::min<size_t>(2, question.size()))));
  }
  return list;
}

nlohmann::json list_isas() {
  nlohmann::json list = nlohmann::json::array();
  for (const Choice& isa : isas())
    list.push_back(entry(isa.name, isa.summary, runs_here(isa.name) ? "" : "this processor has none"));
  return list;
}

/// Those of the study, then those that tests of the tracer judge.
nlohmann::json list_cases() {
  nlohmann::json list;
  for (const Case& one : all_cases()) {
    list.push_back(entry(one.id, fmt::format("{} ({})", one.title, one.source)));
    list.back()["title"] = one.title;
    list.back()["source"] = one.source;
    list.back()["difficulty"] = one.difficulty;
    list.back()["difficulties"] = one.difficulties;
  }
  for (const TracerCase& one : tracer_cases()) {
    list.push_back(
        entry(one.id, fmt::format("{} ({}); checked in {}", one.title, one.source, one.checked_in)));
    list.back()["title"] = one.title;
    list.back()["source"] = one.source;
    list.back()["checked_in"] = one.checked_in;
  }
  return list;
}

nlohmann::json list_of(const std::string& what) {
  if (what == "schedulers") return list_schedulers();
  if (what == "runtimes") return list_runtimes();
  if (what == "scenes") return list_scenes();
  if (what == "modes") return list_modes();
  if (what == "methods") return list_named(methods());
  if (what == "patterns") return list_named(patterns());
  if (what == "cores") return list_named(cores());
  if (what == "accels") return list_named(accels());
  if (what == "precisions") return list_named(precisions());
  if (what == "pins") return list_named(pin_policies());
  if (what == "orders") return list_named(item_orders());
  if (what == "isas") return list_isas();
  if (what == "cases") return list_cases();
  return list_experiments();
}

int run(const std::string& what, bool json) {
  const nlohmann::json list = list_of(what);
  if (json) {
    fmt::print("{}\n", list.dump(1));
    return 0;
  }
  size_t width = 0;
  for (const auto& e : list) width = std::max(width, e["name"].get_ref<const std::string&>().size());
  for (const auto& e : list) {
    const bool available = e["available"].get<bool>();
    std::string counts;
    if (e.contains("triangles"))
      counts = fmt::format(" ({} triangles, {} spheres)", e["triangles"].get<size_t>(),
                           e["spheres"].get<size_t>());
    fmt::print("{:<{}}  {}{}{}\n", e["name"].get<std::string>(), width, e["summary"].get<std::string>(),
               counts, available ? "" : fmt::format("  [not available: {}]", e["reason"].get<std::string>()));
  }
  return 0;
}

}  // namespace

void add_list(CommandLine& line) {
  Command verb = add_verb(line, "list", "what is built in, one line each, with what is missing here and why");
  static std::string what;
  verb.add_option("what", what, "what to list")
      .required()
      .one_of({"schedulers", "runtimes", "scenes", "modes", "methods", "patterns", "cores", "accels",
               "precisions", "pins", "orders", "isas", "cases", "experiments"});
  verb.callback([&line] { line.action = [&line] { return run(what, line.json); }; });
}

}  // namespace raysweep
