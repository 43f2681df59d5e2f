#include "experiments/command_line.h"

#include <CLI/CLI.hpp>
#include <cstdint>

#include "experiments/errors.h"

namespace raysweep {

Option& Option::required() { return option_->required(), *this; }

Option& Option::expected(int least, int most) { return option_->expected(least, most), *this; }

Option& Option::repeated() { return option_->take_all()->expected(1), *this; }

Option& Option::by_commas() { return option_->delimiter(',')->take_all(), *this; }

Option& Option::capture_default_str() { return option_->capture_default_str(), *this; }

Option& Option::range(long least, long most) { return option_->check(CLI::Range(least, most)), *this; }

Option& Option::at_least_0() { return option_->check(CLI::NonNegativeNumber), *this; }

Option& Option::above_0() { return option_->check(CLI::PositiveNumber), *this; }

Option& Option::one_of(std::vector<std::string> values) {
  return option_->check(CLI::IsMember(std::move(values))), *this;
}

Option& Option::check(const std::function<std::string(const std::string&)>& problem_of,
                      const std::string& what) {
  return option_->check(CLI::Validator(problem_of, what)), *this;
}

Command::Command(const std::string& description, const std::string& name)
    : app_(std::make_shared<CLI::App>(description, name)) {}

Command Command::add_subcommand(const std::string& name, const std::string& summary) {
  return Command(app_->get_subcommand_ptr(app_->add_subcommand(name, summary)));
}

void Command::require_subcommand(int least, int most) {
  app_->require_subcommand(static_cast<size_t>(least), static_cast<size_t>(most));
}

std::vector<std::string> Command::subcommand_names() const {
  std::vector<std::string> names;
  for (const CLI::App* command : app_->get_subcommands([](const CLI::App*) { return true; }))
    names.push_back(command->get_name());
  return names;
}

template <class Value>
Option Command::add_option(const std::string& name, Value& value, const std::string& help) {
  return Option(app_->add_option(name, value, help));
}

template Option Command::add_option(const std::string&, int&, const std::string&);
template Option Command::add_option(const std::string&, uint64_t&, const std::string&);
template Option Command::add_option(const std::string&, double&, const std::string&);
template Option Command::add_option(const std::string&, std::string&, const std::string&);
template Option Command::add_option(const std::string&, std::optional<int>&, const std::string&);
template Option Command::add_option(const std::string&, std::optional<uint64_t>&, const std::string&);
template Option Command::add_option(const std::string&, std::optional<double>&, const std::string&);
template Option Command::add_option(const std::string&, std::vector<std::string>&, const std::string&);

void Command::add_option_function(const std::string& name,
                                  const std::function<void(const std::string&)>& take,
                                  const std::string& help) {
  app_->add_option_function<std::string>(name, take, help);
}

void Command::add_flag(const std::string& name, bool& value, const std::string& help) {
  app_->add_flag(name, value, help);
}

void Command::set_version_flag(const std::string& name, const std::string& version) {
  app_->set_version_flag(name, version);
}

void Command::callback(std::function<void()> action) { app_->callback(std::move(action)); }

void Command::allow_extras() { app_->allow_extras(); }

std::vector<std::string> Command::remaining() const { return app_->remaining(); }

bool Command::was_given() const { return app_->parsed(); }

std::string Command::name() const { return app_->get_name(); }

std::optional<int> Command::parse(int argc, char** argv) {
  try {
    app_->parse(argc, argv);
    return {};
  } catch (const CLI::ParseError& error) {
    return app_->exit(error) == 0 ? exit_done : exit_refused;
  }
}

}  // namespace raysweep
