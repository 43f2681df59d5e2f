#include "schedulers/worker_log.h"

#include <sched.h>

#include <algorithm>
#include <array>
#include <limits>

namespace raysweep {

namespace {

/// Follows no item.
constexpr size_t no_item = std::numeric_limits<size_t>::max();

using Sizes = std::vector<std::pair<size_t, size_t>>;

void count(Sizes& sizes, size_t size, size_t times) {
  const auto at = std::ranges::lower_bound(sizes, size, {}, &std::pair<size_t, size_t>::first);
  if (at != sizes.end() && at->first == size) {
    at->second += times;
  } else {
    sizes.insert(at, {size, times});
  }
}

void remember(std::vector<int>& processors, int processor) {
  const auto at = std::ranges::lower_bound(processors, processor);
  if (at == processors.end() || *at != processor) processors.insert(at, processor);
}

}  // namespace

WorkerLog::WorkerLog(int threads, LogDetail detail)
    : detail_(detail), start_(std::chrono::steady_clock::now()), entries_(static_cast<size_t>(threads)) {}

std::chrono::nanoseconds WorkerLog::now() const { return std::chrono::steady_clock::now() - start_; }

void WorkerLog::begin_run() {
  for (WorkerEntry& entry : entries_) entry.next_item_ = no_item;  // a chunk ends with its run
  if (detail_ == LogDetail::counts) return;
  const auto begin = now();
  runs_.emplace_back(begin, begin);
  for (WorkerEntry& entry : entries_) {
    entry.last_end_ = begin;
    entry.busy_before_ = entry.busy;
  }
}

void WorkerLog::end_run() {
  if (detail_ == LogDetail::counts) return;
  const auto end = now();
  runs_.back().second = end;
  std::chrono::nanoseconds busiest{0};
  for (WorkerEntry& entry : entries_) {
    busiest = std::max(busiest, entry.busy - entry.busy_before_);
    entry.idle += end - entry.last_end_;
    if (entry.open_size_ > 0) count(entry.chunk_sizes, entry.open_size_, 1);
    entry.open_size_ = 0;
  }
  busiest_ += busiest;
}

void WorkerLog::note_processor(WorkerEntry& entry) {
  const int processor = sched_getcpu();
  if (processor == entry.last_processor_) return;
  if (entry.last_processor_ >= 0) entry.migrations++;
  remember(entry.processors, processor);
  entry.last_processor_ = processor;
}

void WorkerLog::note_first_processor(WorkerEntry& entry) { entry.processor = sched_getcpu(); }

void WorkerLog::time_chunk(WorkerEntry& entry, size_t first_item, size_t item_count) {
  note_processor(entry);
  if (entry.open_size_ > 0) count(entry.chunk_sizes, entry.open_size_, 1);
  entry.open_size_ = item_count;
  entry.begun_ = now();
  entry.scheduling += entry.begun_ - entry.last_end_;
  if (detail_ == LogDetail::events)
    entry.events.push_back({entry.begun_, entry.begun_, first_item, item_count, entry.last_processor_});
}

void WorkerLog::begin_item(int worker, size_t item) {
  WorkerEntry& entry = entries_[static_cast<size_t>(worker)];
  const bool goes_on = item == entry.next_item_;
  if (!goes_on) return begin_chunk(worker, item, 1);
  entry.items++;
  entry.joined++;
  entry.next_item_++;
  if (detail_ == LogDetail::counts) return;
  entry.open_size_++;
  entry.begun_ = now();
  entry.scheduling += entry.begun_ - entry.last_end_;
  if (detail_ == LogDetail::events) entry.events.back().item_count++;
}

void WorkerLog::end_timed_chunk(WorkerEntry& entry) {
  entry.last_end_ = now();
  entry.busy += entry.last_end_ - entry.begun_;
  if (detail_ == LogDetail::events) entry.events.back().end = entry.last_end_;
}

int WorkerLog::workers_seen() const {
  return static_cast<int>(std::ranges::count_if(entries_, [](const WorkerEntry& e) { return e.items > 0; }));
}

size_t WorkerLog::chunks() const {
  size_t sum = 0;
  for (const WorkerEntry& entry : entries_) sum += entry.chunks;
  return sum;
}

size_t WorkerLog::entries_made() const {
  size_t sum = 0;
  for (const WorkerEntry& entry : entries_) sum += entry.chunks + entry.joined;
  return sum;
}

double WorkerLog::imbalance() const {
  std::chrono::duration<double> busy{0};
  for (const WorkerEntry& entry : entries_) busy += entry.busy;
  if (busy.count() <= 0) return 0;
  return std::chrono::duration<double>(busiest_) / busy * static_cast<double>(entries_.size()) - 1;
}

Sizes WorkerLog::chunk_sizes() const {
  Sizes sum;
  for (const WorkerEntry& entry : entries_) {
    for (const auto& [size, times] : entry.chunk_sizes) count(sum, size, times);
  }
  return sum;
}

std::chrono::duration<double> log_cost_of_a_chunk(LogDetail detail) {
  constexpr size_t chunks = 200;
  std::array<std::chrono::steady_clock::duration, 25> batches;
  for (auto& batch : batches) {
    WorkerLog log(1, detail);
    const auto begin = std::chrono::steady_clock::now();
    log.begin_run();
    for (size_t i = 0; i < chunks; ++i) {
      log.begin_chunk(0, i, 1);
      log.end_chunk(0);
    }
    log.end_run();
    batch = std::chrono::steady_clock::now() - begin;
  }
  std::ranges::sort(batches);
  return std::chrono::duration<double>(batches[batches.size() / 2]) / chunks;
}

}  // namespace raysweep
