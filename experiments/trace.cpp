#include "experiments/trace.h"

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <nlohmann/json.hpp>

#include "tracer/whole_file.h"

namespace raysweep {

namespace {

// Rows of the viewer: frames first, workers below.
constexpr int frames_row = 0, first_worker_row = 1;

/// The format counts in microseconds.
double microseconds(std::chrono::nanoseconds t) {
  return std::chrono::duration<double, std::micro>(t).count();
}

std::string name_of_row(const char* kind, int row, const std::string& name) {
  return nlohmann::json{{"ph", "M"}, {"pid", 0}, {"tid", row}, {"name", kind}, {"args", {{"name", name}}}}
      .dump();
}

void write_names(std::ostream& file, const Cell& cell) {
  const std::string title = fmt::format("{} by {}", cell.scene, cell.scheduler);
  fmt::print(file, "{}", name_of_row("process_name", 0, title));
  fmt::print(file, ",\n{}", name_of_row("thread_name", frames_row, "frames"));
  for (int worker = 0; worker < cell.threads; ++worker) {
    fmt::print(file, ",\n{}",
               name_of_row("thread_name", first_worker_row + worker, fmt::format("worker {}", worker)));
  }
}

/// A span of time in one row; `arguments` is the inside of a JSON object.
void write_span(std::ostream& file, int row, const std::string& name, std::chrono::nanoseconds begin,
                std::chrono::nanoseconds end, const std::string& arguments) {
  fmt::print(
      file,
      ",\n{{\"ph\":\"X\",\"pid\":0,\"tid\":{},\"name\":\"{}\",\"ts\":{:.3f},\"dur\":{:.3f},\"args\":{{{}}}}}",
      row, name, microseconds(begin), microseconds(end - begin), arguments);
}

void write_chunks(std::ostream& file, int row, const WorkerEntry& entry) {
  for (const ChunkEvent& event : entry.events) {
    const size_t last = event.first_item + event.item_count - 1;
    const std::string name = event.item_count == 1 ? fmt::format("item {}", last)
                                                   : fmt::format("items {} to {}", event.first_item, last);
    write_span(file, row, name, event.begin, event.end,
               fmt::format("\"first_item\":{},\"items\":{},\"processor\":{}", event.first_item,
                           event.item_count, event.processor));
  }
}

}  // namespace

void write_trace(const Cell& cell, const RenderJob& job, const std::string& path) {
  const WorkerLog& log = job.log();
  write_whole_file(path, [&](std::ostream& file) {
    fmt::print(file, "{{\"displayTimeUnit\":\"ms\",\"otherData\":{},\n\"traceEvents\":[\n",
               nlohmann::json{{"cell", cell.key()}}.dump());
    write_names(file, cell);
    for (size_t frame = 0; frame < log.runs().size(); ++frame) {
      const auto& [begin, end] = log.runs()[frame];
      write_span(file, frames_row, fmt::format("frame {}", frame), begin, end, "");
    }
    for (size_t worker = 0; worker < log.entries().size(); ++worker)
      write_chunks(file, first_worker_row + static_cast<int>(worker), log.entries()[worker]);
    fmt::print(file, "\n]}}\n");
  });
}

}  // namespace raysweep
