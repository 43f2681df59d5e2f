// Whatever kills a run, fills the disk or forbids to write: finished launches stay, no line is broken, and
// the run can be taken up again.
#include "tests/program/death.h"

#include <gtest/gtest.h>
#include <linux/capability.h>
#include <sys/prctl.h>
#include <sys/resource.h>

#include <csignal>

namespace raysweep {
namespace {

TEST_F(Death, a_launch_that_hangs_is_killed_and_told) {
  const std::string config = sweep(1, "timeout = \"5 s\"\n");
  Program program({"run", config, "--out", out});
  // One that was stopped when it had told its record hangs nobody: go on until one did.
  ASSERT_TRUE(becomes_true([&] {
    if (valid_launches().empty()) return false;  // not the serial picture, which must be had
    for (const pid_t child : children_of(program.pid())) kill(child, SIGSTOP);
    return read_file(records).find("it took longer than a launch may (measure.timeout)") != std::string::npos;
  }));
  const ProgramResult result = program.wait();
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_NE(result.err.find("it took longer than a launch may"), std::string::npos) << result.err;
}

/// A disk that takes no more, as far as a process can tell: the write that does not fit is cut short.
TEST_F(Death, a_full_disk_ends_the_run_with_whole_records_and_it_goes_on_when_there_is_room) {
  const std::string config = sweep(6);
  const ProgramResult full = run_program({"run", config, "--out", out}, [] {
    const rlimit limit{40'000, RLIM_INFINITY};
    setrlimit(RLIMIT_FSIZE, &limit);
  });
  EXPECT_EQ(full.exit_code, 1) << full.err;
  EXPECT_NE(full.err.find("a record cannot be written"), std::string::npos) << full.err;
  EXPECT_NE(full.err.find("finished launches are kept, go on with --resume"), std::string::npos) << full.err;
  const std::string text = read_file(records);
  EXPECT_TRUE(text.ends_with('\n'));
  const size_t kept = valid_launches().size();
  EXPECT_GT(kept, 0u);
  EXPECT_EQ(run_program({"report", out}).exit_code, 0);
  const ProgramResult resumed = run_program({"run", config, "--out", out, "--resume"});
  EXPECT_EQ(resumed.exit_code, 0) << resumed.err;
  EXPECT_EQ(valid_launches(), all_launches(config));
  EXPECT_TRUE(read_file(records).starts_with(text));
}

/// The superuser, too, is refused without this right.
void give_up_overriding_permissions() { prctl(PR_CAPBSET_DROP, CAP_DAC_OVERRIDE, 0, 0, 0); }

TEST_F(Death, a_read_only_folder_is_refused_before_anything_runs) {
  using std::filesystem::perms;
  const std::string config = sweep(6);
  std::filesystem::create_directory(folder.file("locked"));
  std::filesystem::permissions(folder.file("locked"), perms::owner_read | perms::owner_exec);
  for (const char* where : {"locked", "locked/run"}) {
    const ProgramResult result =
        run_program({"run", config, "--out", folder.file(where)}, give_up_overriding_permissions);
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_NE(result.err.find("choose another folder with --out"), std::string::npos) << result.err;
  }
  EXPECT_EQ(folder.entries(), 2u) << "the config and the folder, nothing in it";
  std::filesystem::permissions(folder.file("locked"), perms::owner_all);
}

TEST_F(Death, a_run_whose_folder_became_read_only_still_reports) {
  using std::filesystem::perms;
  const std::string config = sweep(6);
  ASSERT_EQ(run_program({"run", config, "--out", out}).exit_code, 0);
  std::filesystem::remove_all(folder.file("run/tables"));
  std::filesystem::permissions(out, perms::owner_read | perms::owner_exec);
  const ProgramResult result = run_program({"report", out}, give_up_overriding_permissions);
  std::filesystem::permissions(out, perms::owner_all);
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_NE(result.out.find("thread_dynamic"), std::string::npos) << "the table stands on the terminal";
  EXPECT_NE(result.err.find("tables"), std::string::npos) << result.err;
  EXPECT_FALSE(std::filesystem::exists(folder.file("run/tables")));
}

}  // namespace
}  // namespace raysweep
