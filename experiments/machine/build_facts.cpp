// The only file that is compiled anew when the state of the sources changes.
#include "experiments/machine/build_facts.h"

#include <nlohmann/json.hpp>
#include <string_view>

#include "build_settings.h"
#include "git_state.h"

namespace raysweep {

BuildFacts build_facts() {
  BuildFacts facts;
#ifdef __clang__
  facts.compiler = "clang " __clang_version__;
#else
  facts.compiler = "gcc " __VERSION__;
#endif
  facts.type = build_type;
  facts.flags = build_flags;
  facts.sanitizers = build_sanitizers;
  const std::string_view commit = git_commit, changed = git_changed;
  constexpr const char* why = "the sources were not in a git repository of their own";
  facts.commit = commit == "unknown" ? Fact<std::string>::unknown(why) : std::string(commit);
  facts.changed = changed == "unknown" ? Fact<bool>::unknown(why) : changed == "yes";
  return facts;
}

nlohmann::json to_json(const BuildFacts& facts) {
  nlohmann::json json{{"compiler", facts.compiler},
                      {"type", facts.type},
                      {"flags", facts.flags},
                      {"sanitizers", facts.sanitizers}};
  json["commit"] = facts.commit.value.value_or("unknown");
  json["changed"] = !facts.changed.value ? "unknown" : *facts.changed.value ? "yes" : "no";
  return json;
}

}  // namespace raysweep
