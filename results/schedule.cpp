#include "results/schedule.h"

#include <algorithm>
#include <numeric>

namespace raysweep {

namespace {

double frame_count(const Record& r) {
  return r.frame_seconds.empty() ? 0 : static_cast<double>(r.frame_seconds.front().size());
}

/// By all threads, in all frames.
double thread_seconds(const Record& r) { return r.threads * frame_count(r) / r.fps(); }

/// Records of older schemas have no log, and their log_share is 0 too.
bool logged(const Record& r) { return r.log_share > 0; }

double busy_seconds(const Record& r) {
  return std::accumulate(r.workers.begin(), r.workers.end(), 0.0,
                         [](double sum, const WorkerRecord& w) { return sum + w.busy_seconds; });
}

std::optional<double> quality(const Record* own, const Record* serial) {
  return launch_quality(*own, *serial);
}

std::optional<double> inflation(const Record* own, const Record* serial) {
  if (serial->item_seconds.sum <= 0 || !logged(*own)) return std::nullopt;
  return busy_seconds(*own) / frame_count(*own) / serial->item_seconds.sum - 1;
}

std::optional<double> migrations(const Record& r) {
  if (!logged(r)) return std::nullopt;
  uint64_t sum = 0;
  for (const WorkerRecord& w : r.workers) sum += w.migrations;
  return static_cast<double>(sum) / frame_count(r);
}

std::optional<double> empty_region(const Record& r) {
  return r.empty_region_seconds > 0 ? std::optional(r.empty_region_seconds) : std::nullopt;
}

std::optional<Estimate> over_launches(const Rounds& rounds, std::optional<double> (*value)(const Record&)) {
  std::vector<double> samples;
  for (const auto& [round, r] : rounds) {
    if (const auto sample = value(*r)) samples.push_back(*sample);
  }
  if (samples.empty()) return std::nullopt;
  return estimate_median(std::move(samples));
}

/// What is neither in items nor after a worker's last chunk is the scheduler's: also the little that passes
/// before the log begins and after it ends.
TimeShares shares_of(const Record& r) {
  double idle = 0;
  for (const WorkerRecord& w : r.workers) idle += w.idle_seconds;
  TimeShares shares{busy_seconds(r) / thread_seconds(r), 0, idle / thread_seconds(r)};
  shares.scheduling = 1 - shares.busy - shares.idle;
  return shares;
}

std::optional<TimeShares> median_shares(const Rounds& rounds) {
  std::vector<TimeShares> all;
  for (const auto& [round, r] : rounds) {
    if (logged(*r)) all.push_back(shares_of(*r));
  }
  if (all.empty()) return std::nullopt;
  std::ranges::sort(all, {}, &TimeShares::busy);
  return all[(all.size() - 1) / 2];
}

void add_chunks(const Rounds& rounds, Schedule& schedule) {
  std::vector<double> made;
  double frames = 0;  // of launches whose sizes are known
  for (const auto& [round, r] : rounds) {
    for (const uint64_t count : r->chunks_made) made.push_back(static_cast<double>(count));
    if (!r->chunk_sizes.empty()) frames += frame_count(*r);
    for (const auto& [size, count] : r->chunk_sizes) schedule.chunk_sizes[size] += static_cast<double>(count);
  }
  if (!made.empty()) schedule.chunks = median(std::move(made));
  for (auto& [size, count] : schedule.chunk_sizes) count /= frames;
}

}  // namespace

std::optional<double> launch_quality(const Record& own, const Record& serial) {
  const auto [sum, max] = serial.item_seconds;
  if (sum <= 0) return std::nullopt;
  const int most = own.processors_to_use() > 0 ? own.processors_to_use() : own.threads;
  const double bound = std::max(sum / std::min(own.threads, most), max);
  return bound * own.fps();
}

std::optional<double> launch_imbalance(const Record& launch) {
  return logged(launch) ? std::optional(launch.imbalance) : std::nullopt;
}

Schedule schedule_of(const Rounds& own, const Rounds& serial) {
  Schedule schedule;
  schedule.quality = paired(own, serial, quality);
  schedule.inflation = paired(own, serial, inflation);
  schedule.imbalance = over_launches(own, launch_imbalance);
  schedule.shares = median_shares(own);
  schedule.empty_region_seconds = over_launches(own, empty_region);
  schedule.migrations = over_launches(own, migrations);
  add_chunks(own, schedule);
  constexpr int first_schema_with_log = 3;
  schedule.log_off = static_cast<int>(std::ranges::count_if(own, [](const auto& launch) {
    return launch.second->schema >= first_schema_with_log && !logged(*launch.second);
  }));
  return schedule;
}

}  // namespace raysweep
