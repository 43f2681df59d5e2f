#include "experiments/child.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>

#include "experiments/clock.h"
#include "experiments/errors.h"
#include "experiments/interrupt.h"

namespace raysweep {

namespace {

struct Pipe {
  FileDescriptor read, write;

  bool open() {
    std::array<int, 2> ends{-1, -1};
    if (pipe2(ends.data(), O_CLOEXEC) != 0) return false;
    read = FileDescriptor(ends[0]);
    write = FileDescriptor(ends[1]);
    return true;
  }
};

/// What the child does between fork and exec; only async-signal-safe calls.
[[noreturn]] void become(char* const* arguments, pid_t parent, int input, int output, int errors) {
  setpgid(0, 0);
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(127);  // the parent died before the line above
  dup2(input, STDIN_FILENO);
  dup2(output, STDOUT_FILENO);
  dup2(errors, STDERR_FILENO);
  signal(SIGPIPE, SIG_DFL);
  execv("/proc/self/exe", arguments);
  _exit(127);
}

}  // namespace

Child::Child(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), "raysweep");
  std::vector<char*> raw;
  for (std::string& argument : arguments) raw.push_back(argument.data());
  raw.push_back(nullptr);
  Pipe in, out;
  errors_ = FileDescriptor(memfd_create("stderr", MFD_CLOEXEC));
  const bool piped = errors_.is_open() && in.open() && out.open();
  signal(SIGPIPE, SIG_IGN);  // a child that died is told by its end, not by killing us
  const pid_t parent = getpid();
  pid_ = piped ? fork() : -1;
  if (pid_ == 0) become(raw.data(), parent, in.read.get(), out.write.get(), errors_.get());
  if (pid_ < 0) throw WorkError(fmt::format("no process can be started: {}", std::strerror(errno)));
  input_ = std::move(in.write);
  output_ = std::move(out.read);
}

Child::~Child() {
  if (pid_ > 0) {
    kill(pid_, SIGKILL);
    while (waitpid(pid_, nullptr, 0) < 0 && errno == EINTR) {
    }
  }
}

std::optional<std::string> Child::read_line(double deadline) {
  while (true) {
    if (const size_t end = buffer_.find('\n'); end != std::string::npos) {
      std::string line = buffer_.substr(0, end);
      buffer_.erase(0, end + 1);
      return line;
    }
    // The time limit closes the gap between the check and the wait, in which a signal would go unseen.
    pollfd ready{output_.get(), POLLIN, 0};
    if (interrupted() || now_seconds() >= deadline) return std::nullopt;
    if (poll(&ready, 1, 200) <= 0) continue;
    std::array<char, 65536> bytes;
    const ssize_t count = read(output_.get(), bytes.data(), bytes.size());
    if (count == 0 || (count < 0 && errno != EINTR)) return std::nullopt;
    if (count > 0) buffer_.append(bytes.data(), static_cast<size_t>(count));
  }
}

void Child::write_line(const std::string& line) {
  const std::string text = line + "\n";
  // A failure means that the child is gone; reading from it tells how.
  [[maybe_unused]] const ssize_t written = write(input_.get(), text.data(), text.size());
}

std::string Child::how_it_ended() {
  int status = 0;
  while (waitpid(pid_, &status, 0) < 0 && errno == EINTR) {
  }
  pid_ = -1;
  std::array<char, 2000> text{};
  const ssize_t count = pread(errors_.get(), text.data(), text.size(), 0);
  std::string said(text.data(), static_cast<size_t>(std::max<ssize_t>(count, 0)));
  while (!said.empty() && said.back() == '\n') said.pop_back();
  if (WIFSIGNALED(status))
    return fmt::format("killed by signal {} ({}) {}", WTERMSIG(status), strsignal(WTERMSIG(status)), said);
  if (WEXITSTATUS(status) != 0) return fmt::format("exit code {}: {}", WEXITSTATUS(status), said);
  return said.empty() ? "it ended without a record" : said;
}

}  // namespace raysweep
