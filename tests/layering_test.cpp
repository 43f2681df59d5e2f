// The arrows of the house: experiments → tracer, schedulers, results; those three know nothing of each other.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>

namespace {

namespace fs = std::filesystem;

const std::map<std::string, std::set<std::string>> allowed{
    {"tracer", {"tracer"}},
    {"schedulers", {"schedulers"}},
    {"results", {"results"}},
    {"experiments", {"experiments", "tracer", "schedulers", "results"}},
};

/// Own includes of `file` that point to a folder of the house: "tracer/film.h" gives "tracer".
std::set<std::string> included_folders(const fs::path& file) {
  static const std::regex include(R"re(^\s*#\s*include\s*"([a-z_]+)/[^"]+")re");
  std::set<std::string> folders;
  std::ifstream in(file);
  std::string line;
  std::smatch match;
  while (std::getline(in, line)) {
    if (std::regex_search(line, match, include)) folders.insert(match[1]);
  }
  return folders;
}

TEST(layering, every_include_follows_an_arrow) {
  int files = 0;
  for (const auto& [folder, may_include] : allowed) {
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(RAYSWEEP_SOURCE_DIR) / folder)) {
      const std::string extension = entry.path().extension();
      if (extension != ".h" && extension != ".cpp") continue;
      files++;
      for (const std::string& included : included_folders(entry.path())) {
        EXPECT_TRUE(may_include.contains(included)) << entry.path() << " includes " << included << "/…";
      }
    }
  }
  EXPECT_GT(files, 50) << "the test does not see the sources";
}

TEST(layering, the_tracer_has_no_threads_and_no_clocks) {
  static const std::regex forbidden(
      R"(#\s*include\s*<(thread|mutex|atomic|future|chrono|condition_variable|omp\.h|tbb/.*)>)");
  for (const auto& entry : fs::recursive_directory_iterator(fs::path(RAYSWEEP_SOURCE_DIR) / "tracer")) {
    if (!entry.is_regular_file()) continue;
    std::ifstream in(entry.path());
    std::string line;
    while (std::getline(in, line))
      EXPECT_FALSE(std::regex_search(line, forbidden)) << entry.path() << ": " << line;
  }
}

}  // namespace
