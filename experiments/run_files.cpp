#include "experiments/run_files.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "experiments/errors.h"

namespace raysweep {

namespace {

namespace fs = std::filesystem;

/// All of it or nothing, whenever we die.
void write_whole(const fs::path& file, const std::string& text) {
  const fs::path part = file.string() + ".part";
  errno = ENOSPC;  // what a write means that takes less than it was given, without saying so
  const FileDescriptor out(open(part.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644));
  const bool written = out.is_open() &&
                       write(out.get(), text.data(), text.size()) == static_cast<ssize_t>(text.size()) &&
                       fsync(out.get()) == 0 && rename(part.c_str(), file.c_str()) == 0;
  if (written) return;
  const std::string reason = std::strerror(errno);
  unlink(part.c_str());
  throw RequestError(fmt::format("{}: cannot be written: {}", file.string(), reason));
}

std::string read_whole(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

/// Cuts off a line that its writer did not finish, since the next one must not be glued to it.
void drop_unfinished_line(const fs::path& file) {
  const std::string text = read_whole(file);
  const size_t end = text.rfind('\n');
  fs::resize_file(file, end == std::string::npos ? 0 : end + 1);
}

}  // namespace

RunFiles::RunFiles(fs::path path, const RunPapers& papers, const Machine& machine, bool resume)
    : path_(std::move(path)) {
  std::error_code error;
  fs::create_directories(path_, error);
  if (error)
    throw RequestError(fmt::format("{}: cannot be made: {}; choose another folder with --out", path_.string(),
                                   error.message()));
  lock();
  take_up(papers, machine, resume);
  write_whole(path_ / "config.toml", papers.config);
  write_whole(path_ / "plan.json", papers.plan.dump(1) + "\n");
  write_whole(path_ / "machine.json", to_json(machine).dump(1) + "\n");
  const fs::path records = path_ / "records.jsonl";
  file_ = FileDescriptor(open(records.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0644));
  if (!file_.is_open())
    throw RequestError(fmt::format("{}: cannot be written: {}", records.string(), std::strerror(errno)));
}

void RunFiles::lock() {
  const fs::path file = path_ / ".lock";
  lock_ = FileDescriptor(open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644));
  if (!lock_.is_open()) {
    throw RequestError(fmt::format("{}: not writable: {}; choose another folder with --out", path_.string(),
                                   std::strerror(errno)));
  }
  // The kernel lets go of it when we die, so no stale lock can stay behind.
  if (flock(lock_.get(), LOCK_EX | LOCK_NB) != 0) {
    throw RequestError(fmt::format(
        "{}: another run is writing here (process {}); wait for it or choose another folder with --out",
        path_.string(), read_whole(file)));
  }
  const std::string process = std::to_string(getpid());
  if (ftruncate(lock_.get(), 0) != 0 || pwrite(lock_.get(), process.data(), process.size(), 0) < 0) {
    throw RequestError(fmt::format("{}: cannot be written: {}", file.string(), std::strerror(errno)));
  }
}

void RunFiles::take_up(const RunPapers& papers, const Machine& machine, bool resume) {
  const fs::path records = path_ / "records.jsonl";
  if (!fs::exists(records) || fs::file_size(records) == 0) return;
  if (!resume) {
    throw RequestError(
        fmt::format("{}: holds a run already; go on with it by --resume, or choose another folder with --out",
                    path_.string()));
  }
  const auto parse = [&](const char* file) {
    return nlohmann::json::parse(read_whole(path_ / file), nullptr, false);
  };
  // The same run may be asked for in other words.
  const auto without_command = [](nlohmann::json plan) {
    if (plan.is_object()) plan.erase("command");
    return plan;
  };
  const auto old_machine = parse("machine.json"), new_machine = to_json(machine);
  const bool same_machine = old_machine.is_object() && old_machine.value("host", "") == new_machine["host"] &&
                            old_machine.value("cpu", "") == new_machine["cpu"];
  const bool same_program =
      old_machine.is_object() && old_machine.value("build", nlohmann::json()) == new_machine["build"];
  if (read_whole(path_ / "config.toml") != papers.config ||
      without_command(parse("plan.json")) != without_command(papers.plan) || !same_machine) {
    throw RequestError(fmt::format(
        "{}: was made from another config or on another machine; --resume goes on with the same ones only",
        path_.string()));
  }
  if (!same_program) {
    throw RequestError(fmt::format(
        "{}: was made by another build of raysweep (machine.json tells which); a table must not mix them: "
        "measure anew, into another folder, and use `raysweep compare`",
        path_.string()));
  }
  drop_unfinished_line(records);
  holds_records_ = true;
}

void RunFiles::append_text(const std::string& lines, const char* unit) {
  const off_t before = lseek(file_.get(), 0, SEEK_END);
  errno = ENOSPC;  // as above
  const ssize_t written = write(file_.get(), lines.data(), lines.size());
  if (written == static_cast<ssize_t>(lines.size()) && fdatasync(file_.get()) == 0) return;
  const std::string reason = std::strerror(errno);
  const bool taken_back = ftruncate(file_.get(), before) == 0;
  throw WorkError(fmt::format(
      "{}: a record cannot be written ({}){}; finished {} are kept, go on with --resume",
      (path_ / "records.jsonl").string(), reason, taken_back ? "" : " and its beginning stays", unit));
}

}  // namespace raysweep
