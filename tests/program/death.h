// A small sweep that tests can disturb, and what is left of it.
#pragma once

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <string>

#include "tests/program/processes.h"
#include "tests/program/program.h"

namespace raysweep {

using Cells = std::set<std::pair<std::string, int>>;  // cell and round

class Death : public testing::Test {
 public:
  TemporaryFolder folder;
  const std::string out = folder.file("run"), records = folder.file("run/records.jsonl");

  /// A sweep of small pictures by one and two threads, each cell launched `launches` times.
  [[nodiscard]] std::string sweep(int launches, const std::string& measure = {}) const {
    return folder.write(
        "sweep.toml",
        "experiment = \"x\"\n[scene]\nname = \"studio\"\nmodes = [\"low\"]\n[sweep]\nscheduler = "
        "[\"thread_static\", \"thread_dynamic\"]\nthreads = [1, 2]\nwidth = 32\nheight = 32\n"
        "[measure]\nseconds = 0\nbudget = \"20 min\"\nlaunches = " +
            std::to_string(launches) + "\nmax_launches = " + std::to_string(launches) + "\n" + measure);
  }

  /// The launches that count; every line but an unfinished last one must be a record.
  [[nodiscard]] Cells valid_launches() const {
    Cells cells;
    std::istringstream text(read_file(records));
    for (std::string line; std::getline(text, line) && !text.eof();) {
      const auto r = nlohmann::json::parse(line, nullptr, false);
      EXPECT_FALSE(r.is_discarded()) << "a broken line: " << line.substr(0, 200);
      if (r.is_discarded() || !r["valid"]) continue;
      EXPECT_TRUE(cells.emplace(r["cell"], r["round"]).second) << "launched twice";
    }
    return cells;
  }

  /// What is whole of the records file.
  [[nodiscard]] std::string whole_lines() const {
    const std::string text = read_file(records);
    return text.substr(0, text.rfind('\n') + 1);
  }

  /// All launches of the sweep, undisturbed.
  [[nodiscard]] Cells all_launches(const std::string& config) const {
    const auto plan = nlohmann::json::parse(run_program({"run", config, "--dry-run", "--json"}).out);
    Cells cells;
    for (const auto& cell : plan[0]["cells"]) {
      for (int round = 0; round < plan[0]["rounds"]; ++round) cells.emplace(cell["cell"], round);
    }
    return cells;
  }
};

}  // namespace raysweep
