// Accuracy experiments on several threads: the records are those of one.
#include "experiments/accuracy_run.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "experiments/machine/machine.h"

namespace raysweep {
namespace {

class AccuracyThreads : public testing::Test {
 protected:
  AccuracyThreads() {
    folder_ = std::filesystem::temp_directory_path() / ("raysweep_accuracy_run_" + std::to_string(getpid()));
    std::filesystem::remove_all(folder_);
  }
  ~AccuracyThreads() override { std::filesystem::remove_all(folder_); }

  [[nodiscard]] std::filesystem::path records_of(const std::string& run) const {
    return folder_ / run / "records.jsonl";
  }
  [[nodiscard]] std::string text_of(const std::string& run) const {
    std::ifstream in(records_of(run), std::ios::binary);
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
  }

  /// Two methods on cases whose batches take long or little by turns; the report of a run into the folder
  /// `name`.
  [[nodiscard]] AccuracyReport run(const std::string& name, size_t threads, bool resume = false) const {
    const AccuracyConfig config = parse_accuracy_config(
        "experiment = \"x\"\nkind = \"accuracy\"\n[sweep]\nmethod = [\"wald\", \"woop_watertight\"]\n"
        "case = [\"W6\", \"N6\", \"F2\", \"D5\"]\nvariant = \"star\"\n[measure]\ntrials = 60\n",
        "x.toml", {});
    AccuracyExperiment experiment = open_accuracy(config, folder_ / name, machine_, resume);
    experiment.plan.threads = threads;
    return run_accuracy(experiment, true);
  }

 private:
  std::filesystem::path folder_;
  Machine machine_ = detect_machine();
};

TEST_F(AccuracyThreads, give_the_same_bytes_however_many_they_are) {
  const AccuracyReport report = run("one", 1);
  EXPECT_EQ(report.failure, "");
  EXPECT_EQ(run("three", 3).cells, report.cells);
  const std::string records = text_of("one");
  EXPECT_EQ(static_cast<size_t>(std::count(records.begin(), records.end(), '\n')), report.cells);
  EXPECT_EQ(text_of("three"), records);
}

TEST_F(AccuracyThreads, go_on_where_others_were_stopped_and_end_with_the_same_bytes) {
  (void)run("whole", 1);
  (void)run("cut", 2);
  const std::string whole = text_of("whole");
  // In the middle of a record, and that in the middle of a batch.
  size_t end = 0;
  for (int i = 0; i < 30; ++i) end = whole.find('\n', end) + 1;
  std::filesystem::resize_file(records_of("cut"), end + 100);
  EXPECT_FALSE(run("cut", 3, true).was_interrupted);
  EXPECT_EQ(text_of("cut"), whole);
}

TEST_F(AccuracyThreads, leave_the_fields_that_every_record_has) {
  (void)run("a", 2);
  for (const AccuracyRecord& record : read_accuracy_records(records_of("a"))) {
    EXPECT_EQ(record.schema, accuracy_schema);
    EXPECT_EQ(record.kind, "accuracy");
    EXPECT_EQ(record.launch, 0);
    EXPECT_EQ(record.round, 0);
    EXPECT_TRUE(record.valid);
    EXPECT_EQ(record.reason, "");
  }
}

}  // namespace
}  // namespace raysweep
