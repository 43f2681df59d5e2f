// What each worker did: how much, how long, where, and chunk by chunk.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace raysweep {

enum class LogDetail {
  counts,  // items and chunks: a few additions a chunk
  times,   // and the clock, the processor and the size of each chunk
  events   // and each chunk by itself, for a timeline
};

/// One chunk of a timeline. Times count from the log's first run.
struct ChunkEvent {
  std::chrono::nanoseconds begin, end;
  size_t first_item, item_count;
  int processor;
};

/// What one worker did, summed over runs. Its worker alone writes it, in cache lines of its own: two, since
/// processors fetch them in pairs.
struct alignas(128) WorkerEntry {
  size_t items = 0, chunks = 0;
  size_t joined = 0;      // calls that went on with a chunk: see begin_item
  int processor = -1;     // where its first chunk ran; −1: it ran none
  size_t migrations = 0;  // chunks that began on another processor than the one before

  // Of each run, from beginning to end: in bodies; waiting for the first chunk and between chunks; after the
  // last one. Their sum over all workers is the time of all runs times the threads.
  std::chrono::nanoseconds busy{0}, scheduling{0}, idle{0};
  std::vector<std::pair<size_t, size_t>> chunk_sizes;  // how many chunks (second) of which size, ascending
  std::vector<ChunkEvent> events;
  std::vector<int> processors;  // all on which its chunks began, ascending

 private:
  friend class WorkerLog;
  std::chrono::nanoseconds begun_{0}, last_end_{0};
  int last_processor_ = -1;
  size_t open_size_ = 0;                     // of the last chunk, not yet in chunk_sizes
  size_t next_item_ = 0;                     // where it ended
  std::chrono::nanoseconds busy_before_{0};  // this run
};

/// What all workers did, summed over the runs that were given this log.
class WorkerLog {
 public:
  explicit WorkerLog(int threads, LogDetail detail = LogDetail::counts);

  void begin_run();
  void end_run();
  /// Inline as far as counts go: with chunks of some ten nanoseconds, two calls for each would be seen.
  void begin_chunk(int worker, size_t first_item, size_t item_count) {
    WorkerEntry& entry = entries_[static_cast<size_t>(worker)];
    entry.items += item_count;
    entry.next_item_ = first_item + item_count;
    const bool first = entry.chunks++ == 0;
    if (first) note_first_processor(entry);
    if (detail_ != LogDetail::counts) time_chunk(entry, first_item, item_count);
  }
  void end_chunk(int worker) {
    if (detail_ != LogDetail::counts) end_timed_chunk(entries_[static_cast<size_t>(worker)]);
  }
  /// An item whose chunk only a library knows: successive items count as one chunk, so that neighbouring
  /// chunks of one worker are taken for one.
  void begin_item(int worker, size_t item);

  [[nodiscard]] LogDetail detail() const { return detail_; }
  [[nodiscard]] const std::vector<WorkerEntry>& entries() const { return entries_; }
  /// Begin and end of each run, on the events' clock.
  [[nodiscard]] const std::vector<std::pair<std::chrono::nanoseconds, std::chrono::nanoseconds>>& runs()
      const {
    return runs_;
  }
  /// Workers that ran at least one item.
  [[nodiscard]] int workers_seen() const;
  [[nodiscard]] size_t chunks() const;
  /// How often the log was written to: chunks, and the items that were told one by one.
  [[nodiscard]] size_t entries_made() const;
  /// How much longer the busiest worker of a run was busy than the mean one, over all runs: max/mean − 1. 0
  /// where there are no times. Run by run: what one run has too much, another must not make up for.
  [[nodiscard]] double imbalance() const;
  /// All workers' chunk sizes together.
  [[nodiscard]] std::vector<std::pair<size_t, size_t>> chunk_sizes() const;

 private:
  [[nodiscard]] std::chrono::nanoseconds now() const;
  static void note_first_processor(WorkerEntry& entry);
  static void note_processor(WorkerEntry& entry);
  void time_chunk(WorkerEntry& entry, size_t first_item, size_t item_count);
  void end_timed_chunk(WorkerEntry& entry);

  LogDetail detail_;
  std::chrono::nanoseconds busiest_{0};  // sum over runs of the most that one worker was busy
  std::chrono::steady_clock::time_point start_;
  std::vector<WorkerEntry> entries_;
  std::vector<std::pair<std::chrono::nanoseconds, std::chrono::nanoseconds>> runs_;
};

/// What logging one chunk in `detail` costs on this machine, now: the median over a few thousand chunks.
[[nodiscard]] std::chrono::duration<double> log_cost_of_a_chunk(LogDetail detail);

}  // namespace raysweep
