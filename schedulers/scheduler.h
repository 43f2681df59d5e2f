// The contract: run every item once; an item writes only its own slot; return when all are done; rethrow the
// first error after all workers stopped.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace raysweep {

/// The work of one run: items 0 … count − 1, each independent of the others.
struct ItemSpace {
  size_t count = 0;
};

/// Runs items begin … end − 1 as worker 0 ≤ worker < threads. Called from several threads at once, never
/// twice at once for one worker.
using Body = std::function<void(size_t begin, size_t end, int worker)>;

/// How many items are handed out at once: a count of items, or so many chunks for each thread.
struct Chunk {
  int value = 1;
  bool per_thread = false;

  /// "4" or "2/thread".
  [[nodiscard]] std::string text() const { return std::to_string(value) + (per_thread ? "/thread" : ""); }

  /// Items a chunk, at least 1. Per-thread chunks are rounded up, so that there are at most `threads · value`
  /// of them.
  [[nodiscard]] size_t size(size_t item_count, int threads) const {
    const auto v = static_cast<size_t>(value);
    if (!per_thread) return v;
    const size_t parts = static_cast<size_t>(threads) * v;
    return std::max<size_t>(1, (item_count + parts - 1) / parts);
  }
};
inline constexpr int max_chunk = 1 << 24;

/// What one worker did. A cache line of its own, since its worker writes it during the run.
struct alignas(128) WorkerEntry {
  size_t items = 0, chunks = 0;
  size_t last_end = 0;  // of its last call
  int processor = -1;   // where the worker's first chunk ran; −1 if it ran none
};

/// What all workers did, summed over the runs that were given this log.
class WorkerLog {
 public:
  explicit WorkerLog(int threads) : entries_(static_cast<size_t>(threads)) {}

  /// `joined`: a call that goes on where this worker's last one ended belongs to the same chunk.
  void ran(int worker, size_t begin, size_t end, bool joined);
  [[nodiscard]] const std::vector<WorkerEntry>& entries() const { return entries_; }
  /// Workers that ran at least one item.
  [[nodiscard]] int workers_seen() const;

 private:
  std::vector<WorkerEntry> entries_;
};

/// A pool of workers and a way to share items among them. The constructor owns the pool; threads are warm
/// from the first run on.
class Scheduler {
 public:
  virtual ~Scheduler() = default;

  /// Runs every item once. When a body throws, chunks not yet begun are dropped, and the first error is
  /// rethrown here after all workers stopped; the scheduler stays usable. Not to be called from two threads
  /// at once.
  void run(const ItemSpace& items, const Chunk& chunk, const Body& body, WorkerLog& log);

 private:
  /// Whether chunks come in several calls, item by item. They are then counted as runs of successive items,
  /// which takes two neighbouring chunks of one worker for one.
  [[nodiscard]] virtual bool calls_by_item() const { return false; }

  /// Covers [0, items.count) with calls of `body`, which never throws.
  virtual void run_items(const ItemSpace& items, const Chunk& chunk, const Body& body) = 0;
};

}  // namespace raysweep
