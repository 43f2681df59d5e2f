// What a command line can hold: commands, their options and flags. Names and meanings are CLI11's, which does
// the work. All of CLI11 is in headers, and each source that includes them compiles seconds of it: so
// command_line.cpp alone does.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace raysweep {

/// What more there is to say of an option that was added.
class Option {
 public:
  explicit Option(CLI::Option* option) : option_(option) {}

  Option& required();
  Option& expected(int least, int most);
  /// One value each time that it is given, and all of them count.
  Option& repeated();
  /// Values by commas, and all of them count.
  Option& by_commas();
  /// Help tells the value that it has now.
  Option& capture_default_str();

  Option& range(long least, long most);
  Option& at_least_0();
  Option& above_0();
  Option& one_of(std::vector<std::string> values);
  /// `problem_of` gives what is wrong with a value, or nothing; help calls a value `what`.
  Option& check(const std::function<std::string(const std::string&)>& problem_of, const std::string& what);

 private:
  CLI::Option* option_;
};

/// A program, or one of its verbs. Copies are the same command.
class Command {
 public:
  Command(const std::string& description, const std::string& name);

  Command add_subcommand(const std::string& name, const std::string& summary);
  void require_subcommand(int least, int most);
  [[nodiscard]] std::vector<std::string> subcommand_names() const;

  /// `Value`s are strings, numbers, what is optional of them, and lists of strings.
  template <class Value>
  Option add_option(const std::string& name, Value& value, const std::string& help = {});
  void add_option_function(const std::string& name, const std::function<void(const std::string&)>& take,
                           const std::string& help);
  void add_flag(const std::string& name, bool& value, const std::string& help);
  void set_version_flag(const std::string& name, const std::string& version);

  /// Called when the command has been parsed.
  void callback(std::function<void()> action);
  /// What is no option of the command is kept as `remaining`.
  void allow_extras();
  [[nodiscard]] std::vector<std::string> remaining() const;
  [[nodiscard]] bool was_given() const;
  [[nodiscard]] std::string name() const;

  /// The exit code, if nothing is left to do: help was asked for and printed, or an error was told.
  [[nodiscard]] std::optional<int> parse(int argc, char** argv);

 private:
  explicit Command(std::shared_ptr<CLI::App> app) : app_(std::move(app)) {}

  std::shared_ptr<CLI::App> app_;
};

}  // namespace raysweep
