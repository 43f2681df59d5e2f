// The experiments of this checkout, as they are on machines that are not here.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <numeric>
#include <set>
#include <sstream>

#include "experiments/accuracy_config.h"
#include "experiments/config_toml.h"
#include "experiments/errors.h"
#include "experiments/include_list.h"
#include "experiments/kernel_plan.h"
#include "experiments/pixels_config.h"
#include "experiments/plan.h"
#include "experiments/read_claims.h"

namespace raysweep {
namespace {

namespace fs = std::filesystem;

const fs::path folder = fs::path(RAYSWEEP_SOURCE_DIR) / "experiments/configs";

std::vector<std::string> files() {
  std::vector<std::string> list;
  for (const auto& file : fs::directory_iterator(folder)) {
    if (file.path().extension() == ".toml") list.push_back(file.path().string());
  }
  std::ranges::sort(list);
  return list;
}

/// Without hyper-threading, and with it.
std::vector<MachineSize> machines() {
  std::vector<MachineSize> list;
  for (const auto& [cores, pus] : {std::pair{1, 1}, {2, 2}, {6, 12}, {64, 128}}) {
    std::vector<int> processors(static_cast<size_t>(pus));
    std::iota(processors.begin(), processors.end(), 0);
    list.push_back({cores, pus, processors, {}});
  }
  return list;
}

/// How many cells the plan has. Of a list none.
size_t plan_size(const std::string& file, const std::vector<std::string>& overrides,
                 const MachineSize& machine) {
  const std::string text = read_config_text(file);
  if (read_include_list(text, file)) return 1;
  if (is_accuracy(text, file, overrides)) return parse_accuracy_config(text, file, overrides).methods.size();
  if (is_kernel(text, file, overrides))
    return make_plan(parse_kernel_config(text, file, overrides, machine.pus)).cells.size();
  if (is_pixels(text, file, overrides))
    return !parse_pixels_config(text, file, overrides).settings.experiment.empty();
  const Config config = parse_config(text, file, overrides, machine);
  return config.not_here.empty() ? make_plan(config, machine).cells.size() : 1;
}

/// Where a runtime is missing, or these tests hold another that would disturb it, an experiment that needs it
/// says so, and nothing else is wrong with it.
void expect_plan(const std::string& file, const std::vector<std::string>& overrides,
                 const MachineSize& machine) {
  try {
    EXPECT_GT(plan_size(file, overrides, machine), 0u) << file;
  } catch (const RequestError& error) {
    std::istringstream lines(error.what());
    for (std::string line; std::getline(lines, line);) {
      EXPECT_NE(line.find("cannot be used here: it is not "), std::string::npos)
          << line << " on " << machine.cores << " cores, " << machine.pus << " processors";
    }
  }
}

TEST(configs, every_one_can_be_planned_on_small_and_large_machines) {
  for (const std::string& file : files()) {
    for (const MachineSize& machine : machines()) expect_plan(file, {}, machine);
  }
}

TEST(configs, every_one_can_be_planned_in_its_quick_form) {
  size_t quick = 0;
  for (const std::string& file : files()) {
    const auto overrides = quick_overrides(read_toml(read_config_text(file), file, {}));
    quick += !overrides.empty();
    for (const MachineSize& machine : machines()) expect_plan(file, overrides, machine);
  }
  EXPECT_GT(quick, 10u) << "whose quick forms were tried";
}

TEST(configs, what_all_includes_has_a_quick_form_and_claims_to_be_judged) {
  const std::string all = (folder / "all.toml").string();
  const auto list = read_include_list(read_config_text(all), all);
  ASSERT_TRUE(list);
  for (const std::string& file : list->files) {
    const toml::table root = read_toml(read_config_text(file), file, {});
    EXPECT_FALSE(quick_overrides(root).empty()) << file;
    EXPECT_TRUE(root.contains("claim")) << file;
  }
}

}  // namespace
}  // namespace raysweep
