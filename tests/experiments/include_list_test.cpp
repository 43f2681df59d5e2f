#include "experiments/include_list.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "experiments/errors.h"

namespace raysweep {
namespace {

class IncludeListTest : public testing::Test {
 public:
  IncludeListTest() {
    std::string pattern = (std::filesystem::temp_directory_path() / "raysweep-include-XXXXXX").string();
    folder_ = mkdtemp(pattern.data());
    write("a.toml", "experiment = \"a\"\n");
    write("b.toml", "experiment = \"b\"\n");
    write("list.toml", "experiment = \"list\"\ninclude = [\"a.toml\"]\n");
  }
  ~IncludeListTest() override { std::filesystem::remove_all(folder_); }

  void write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
  }
  [[nodiscard]] std::string path(const std::string& name) const { return (folder_ / name).string(); }

  [[nodiscard]] std::string errors(const std::string& text) const {
    try {
      (void)read_include_list(text, path("all.toml"));
    } catch (const RequestError& error) {
      return error.what();
    }
    return "";
  }

 private:
  std::filesystem::path folder_;
};

const std::string head = "experiment = \"all\"\n";

TEST_F(IncludeListTest, files_are_found_from_where_the_list_stands) {
  const auto list = read_include_list(head + "include = [\"b.toml\", \"a.toml\"]\n", path("all.toml"));
  ASSERT_TRUE(list);
  EXPECT_EQ(list->name, "all");
  EXPECT_EQ(list->files, (std::vector<std::string>{path("b.toml"), path("a.toml")}));
}

TEST_F(IncludeListTest, an_experiment_is_no_list) {
  EXPECT_FALSE(read_include_list(head + "[sweep]\nthreads = 1\n", path("all.toml")));
}

TEST_F(IncludeListTest, a_list_says_nothing_of_experiments) {
  EXPECT_EQ(errors(head + "include = [\"a.toml\"]\n[sweep]\nthreads = 2\n"),
            path("all.toml:3") + ": unknown key \"sweep\"; possible: experiment, title, include");
}

TEST_F(IncludeListTest, all_that_is_wrong_is_told_at_once) {
  EXPECT_EQ(errors(head + "include = [\"a.toml\",\n\"none.toml\",\n\"a.toml\",\n3,\n\"list.toml\"]\n"),
            path("all.toml:3") + ": include \"none.toml\": there is no file " + path("none.toml") + "\n" +
                path("all.toml:4") + ": include \"a.toml\": it is there twice\n" + path("all.toml:5") +
                ": include must be strings in quotes\n" + path("all.toml:6") +
                ": include \"list.toml\": it includes files itself; name these here");
}

TEST_F(IncludeListTest, a_list_names_one_file_at_least) {
  const std::string sentence =
      path("all.toml:2") + ": include must be a list of files, such as [\"m11-t3.toml\", \"m11-t4.toml\"]";
  EXPECT_EQ(errors(head + "include = []\n"), sentence);
  EXPECT_EQ(errors(head + "include = \"a.toml\"\n"), sentence);
}

TEST_F(IncludeListTest, a_list_has_a_name) {
  EXPECT_EQ(
      errors("include = [\"a.toml\"]\n"),
      path("all.toml:1") + ": experiment must be a name, such as \"M11-T3\"; it names the folder of the run");
}

}  // namespace
}  // namespace raysweep
