#include "experiments/overhead/report.h"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>

#include "experiments/errors.h"

namespace raysweep {

namespace {

void write_file(const std::filesystem::path& path, const std::string& text) {
  std::ofstream file(path, std::ios::binary);
  file << text;
  file.close();
  if (!file) throw WorkError(fmt::format("{} cannot be written", path.string()));
}

}  // namespace

std::string machine_line(const Machine& machine) {
  const MachineRecord record = machine_record(machine);
  return fmt::format("{}: {}, {} cores, {} processors; {}; {}; load {:.2f}", record.host, record.cpu,
                     record.cores, record.pus, machine.kernel, machine.compiler, record.load);
}

void print_report(const Report& report, const Machine& machine) {
  fmt::print("{}\n{}\n", report.title, machine_line(machine));
  for (const ReportPart& part : report.parts) {
    if (!part.table.columns.empty()) fmt::print("\n{}\n\n{}", part.explanation, to_text(part.table));
  }
}

void make_report_folder(const std::string& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error || !std::filesystem::is_directory(folder))
    throw RequestError(fmt::format("--out: the folder {} cannot be made: {}", folder, error.message()));
}

void write_report(const Report& report, const Machine& machine, const std::string& folder) {
  std::string text = fmt::format("# {}\n\n{}\n", report.title, machine_line(machine));
  for (const ReportPart& part : report.parts) {
    if (!part.table.columns.empty())
      text += fmt::format("\n{}\n\n{}", part.explanation, to_markdown(part.table));
    write_file(std::filesystem::path(folder) / (part.name + ".csv"), to_csv(part.numbers));
  }
  write_file(std::filesystem::path(folder) / (report.name + ".md"), text);
}

}  // namespace raysweep
