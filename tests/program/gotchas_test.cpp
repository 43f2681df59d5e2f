// What surrounds the program and changes what it would measure: seen, or refused by a sentence.
#include <gtest/gtest.h>
#include <sched.h>

#include <cstdlib>
#include <nlohmann/json.hpp>

#include "tests/program/program.h"

namespace raysweep {
namespace {

/// The environment of a program started meanwhile.
class Variable {
 public:
  Variable(const char* name, const std::string& value) : name_(name) { setenv(name, value.c_str(), 1); }
  ~Variable() { unsetenv(name_); }
  Variable(const Variable&) = delete;
  Variable& operator=(const Variable&) = delete;

 private:
  const char* name_;
};

/// One processor for this thread and the programs that it starts, as `taskset -c` gives it.
class OneProcessor {
 public:
  OneProcessor() {
    sched_getaffinity(0, sizeof before_, &before_);
    cpu_set_t one;
    CPU_ZERO(&one);
    for (size_t p = 0; p < CPU_SETSIZE && CPU_COUNT(&one) == 0; ++p) {
      if (CPU_ISSET(p, &before_)) CPU_SET(p, &one);
    }
    sched_setaffinity(0, sizeof one, &one);
  }
  ~OneProcessor() { sched_setaffinity(0, sizeof before_, &before_); }
  OneProcessor(const OneProcessor&) = delete;
  OneProcessor& operator=(const OneProcessor&) = delete;

 private:
  cpu_set_t before_{};
};

nlohmann::json runtime(const std::string& name) {
  for (const auto& entry : nlohmann::json::parse(run_program({"list", "runtimes", "--json"}).out)) {
    if (entry["name"] == name) return entry;
  }
  return {};
}

// Gotcha 5: an OpenMP program made by g++ runs on libomp when that is preloaded, but for its static loops,
// which are inlined; a measurement of "libgomp" would then be of neither.
TEST(gotchas, a_preloaded_libomp_is_no_libgomp) {
  const auto libomp = runtime("libomp");
  if (!libomp["available"] || !runtime("libgomp")["available"])
    GTEST_SKIP() << "libgomp and libomp are needed";
  const std::string summary = libomp["summary"];  // ends with the library's file
  const Variable preload("LD_PRELOAD", summary.substr(summary.rfind(' ') + 1));
  const TemporaryFolder folder;
  const ProgramResult result =
      run_program({"render", "--scene", "studio", "--width", "16", "--height", "16", "--scheduler",
                   "omp_dynamic", "--runtime", "libgomp", "--out", folder.file("p.png")});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_NE(result.err.find("\"libgomp\" cannot be used here"), std::string::npos) << result.err;
  EXPECT_NE(result.err.find("libomp.so"), std::string::npos) << result.err;
  EXPECT_EQ(folder.entries(), 0u);
  EXPECT_FALSE(runtime("libgomp")["available"]);
  EXPECT_TRUE(runtime("libomp")["available"]);
}

// Gotcha 11: std::thread::hardware_concurrency() counts processors that this process may not use.
TEST(gotchas, processors_that_are_not_allowed_are_not_there) {
  const OneProcessor one;
  EXPECT_EQ(nlohmann::json::parse(run_program({"topology", "--json"}).out)["pus"], 1);
  const TemporaryFolder folder;
  const std::string config = folder.write(
      "sweep.toml", "experiment = \"x\"\n[sweep]\nscheduler = \"thread_static\"\nthreads = \"1..2*pus\"\n");
  const ProgramResult plan = run_program({"run", config, "--dry-run"});
  EXPECT_EQ(plan.exit_code, 0) << plan.err;
  EXPECT_NE(plan.out.find("threads=2"), std::string::npos) << plan.out;
  EXPECT_EQ(plan.out.find("threads=3"), std::string::npos) << plan.out;
}

/// Gotcha 3: what a user's shell says of waiting must not pass for the default; the cell alone decides.
TEST(gotchas, launches_do_not_inherit_what_runtimes_read) {
  const TemporaryFolder folder;
  const std::string config =
      folder.write("x.toml",
                   "experiment = \"x\"\n[sweep]\nscheduler = \"omp_static\"\nthreads = 2\nwidth = "
                   "32\nheight = 24\nenvironment = "
                   "[\"\", \"OMP_DISPLAY_ENV=true\"]\n[measure]\nlaunches = 1\nseconds = 0\n");
  // A static schedule has a part for each thread, however late it comes.
  setenv("OMP_THREAD_LIMIT", "1", 1);  // would leave one thread of two
  const ProgramResult result = run_program({"run", config, "--out", folder.file("run"), "--json"});
  unsetenv("OMP_THREAD_LIMIT");
  if (result.exit_code == 2) GTEST_SKIP() << "no OpenMP here: " << result.err;
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const auto document = nlohmann::json::parse(result.out);
  for (const auto& row : document.at(0).at("rows")) {
    if (row.at("scheduler") == "omp_static") {
      EXPECT_EQ(row.at("threads_seen"), row.at("threads"));
    }
  }
}

}  // namespace
}  // namespace raysweep
