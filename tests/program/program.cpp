#include "tests/program/program.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <fstream>
#include <sstream>

namespace raysweep {

namespace {

std::filesystem::path temporary_file() {
  std::string name = std::filesystem::temp_directory_path() / "raysweep_output_XXXXXX";
  close(mkstemp(name.data()));
  return name;
}

}  // namespace

Program::Program(std::vector<std::string> arguments, void (*prepare)())
    : out_(temporary_file()), err_(temporary_file()) {
  arguments.insert(arguments.begin(), RAYSWEEP_PROGRAM);
  std::vector<char*> raw;
  for (std::string& a : arguments) raw.push_back(a.data());
  raw.push_back(nullptr);
  pid_ = fork();
  if (pid_ != 0) return;
  dup2(open(out_.c_str(), O_WRONLY | O_TRUNC), STDOUT_FILENO);
  dup2(open(err_.c_str(), O_WRONLY | O_TRUNC), STDERR_FILENO);
  if (prepare) prepare();
  execv(raw[0], raw.data());
  _exit(127);
}

Program::~Program() {
  if (pid_ > 0) {
    kill(pid_, SIGKILL);
    waitpid(pid_, nullptr, 0);
  }
  std::filesystem::remove(out_);
  std::filesystem::remove(err_);
}

void Program::send(int signal) const { kill(pid_, signal); }

ProgramResult Program::wait() {
  int status = 0;
  waitpid(pid_, &status, 0);
  pid_ = -1;
  return {WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status), read_file(out_),
          read_file(err_)};
}

ProgramResult run_program(std::vector<std::string> arguments, void (*prepare)()) {
  return Program(std::move(arguments), prepare).wait();
}

TemporaryFolder::TemporaryFolder() {
  std::string name = std::filesystem::temp_directory_path() / "raysweep_test_XXXXXX";
  path_ = mkdtemp(name.data());
}

TemporaryFolder::~TemporaryFolder() { std::filesystem::remove_all(path_); }

std::string TemporaryFolder::write(const std::string& name, const std::string& text) const {
  std::ofstream(path_ / name, std::ios::binary) << text;
  return file(name);
}

size_t TemporaryFolder::entries() const {
  size_t count = 0;
  for ([[maybe_unused]] const auto& entry : std::filesystem::recursive_directory_iterator(path_)) count++;
  return count;
}

std::string read_file(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

}  // namespace raysweep
