// One launch, as it is written down: one line of records.jsonl. The schema is versioned; a reader refuses
// what it does not know.
#pragma once

#include <cstdint>
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace raysweep {

/// Older schemas are still read. 2 adds pixel_tolerance, branches and left_out; 3 what schedulers did: order,
/// wait_policy, spin_count, environment, library (which `runtime` held before), cores_seen, chunk_sizes,
/// item_seconds, empty_region_seconds, shares_cache_lines, imbalance,
/// log_share, and the workers' times; 4 what the machine did meanwhile: state, launch_seconds, warm; twin
/// and slowdown; scene_hash and config_hash; the machine's quota.
inline constexpr int record_schema = 4, oldest_record_schema = 1;

/// What one worker did during the timed frames. The times add up to those of the frames; they and the
/// migrations are 0 where the log was off.
struct WorkerRecord {
  uint64_t items = 0, chunks = 0;
  double busy_seconds = 0;        // inside items
  double scheduling_seconds = 0;  // before the first chunk, and between chunks
  double idle_seconds = 0;        // after the last chunk
  int cpu = -1;                   // where its first chunk ran
  uint64_t migrations = 0;        // chunks that began on another processor than the one before
};

/// How many chunks (second) of how many items (first), in all timed frames.
using ChunkSizes = std::vector<std::pair<uint64_t, uint64_t>>;

/// What the items of one frame cost on one thread: the bounds of every schedule. 0 where it was not measured.
struct ItemSeconds {
  double sum = 0, max = 0;
};

/// Rays of one frame, by kind.
struct RayRecord {
  uint64_t primary = 0, shadow = 0, reflected = 0, refracted = 0;
  friend bool operator==(const RayRecord&, const RayRecord&) = default;
};

/// What one frame left out: rays not traced, by reason, and the most that a sample lacks by the last two.
struct LeftOutRecord {
  uint64_t by_depth = 0, by_tolerance = 0, by_branches = 0;
  double bound = 0;
  uint64_t lost_media = 0;  // paths that left the scene though they were inside something
};

/// The machine as far as tables need it; machine.json holds the rest.
struct MachineRecord {
  std::string host, cpu;
  int pus = 0;                    // processors that the run was allowed to use
  int cores = 0;                  // physical cores among them
  double load = 0;                // one-minute load average when the launch began
  std::optional<double> quota{};  // processors that the control group allows; none: unlimited or unknown
};

/// What the machine did during the timed frames of a launch; none: this machine does not tell.
struct LaunchState {
  std::optional<double> wall_seconds;      // for which the following were counted
  std::optional<double> other_processors;  // that other processes used, on average
  std::optional<double> steal_share;       // of our processors' time that the hypervisor gave to others
  std::optional<double> pressure_share;    // of the time, some thread of the machine waited for a processor
  std::optional<double> throttled_seconds, thermal_throttles;  // by a quota; because it was hot
  std::optional<double> voluntary_switches, involuntary_switches, major_faults;
  std::optional<double> spin_before_seconds, spin_after_seconds;  // of a fixed chain of instructions
};

/// A launch of a picture. Strings are the names of configs and command line; times are seconds.
struct Record {
  int schema = record_schema;
  std::string kind = "picture", experiment, cell;
  int launch = 0, round = 0;  // number of the launch in its run; round of its cell
  uint64_t seed = 0;
  bool valid = true;
  std::string reason;  // why it is not
  MachineRecord machine;
  LaunchState state;
  double launch_seconds = 0;  // from the start of its process to its record

  std::string scene, mode, pattern, accel, core, isa, method, precision, scheduler, runtime, item, chunk, pin;
  std::string order = "scanline", wait_policy = "default", spin_count = "default", environment;
  std::string library;  // what ran the scheduler: version, file, fingerprint
  int width = 0, height = 0, subpixels = 0, depth = 0, branches = 1024, lights = 0, leaf = 0;
  double pixel_tolerance = 0;
  int threads = 0, threads_seen = 0;
  int cores_seen = 0, processors_seen = 0;  // that workers were bound to or ran on; 0: unknown
  int processes = 1;                        // more than 1: co-running copies of one launch
  int twin = 0;         // above 0: another launch of the same cell in each round; what differs is noise
  double slowdown = 0;  // planted: each frame was made longer by this share of its time

  std::vector<std::vector<double>> frame_seconds;  // by process
  std::vector<double> warmup_seconds;              // the first one is the cold frame
  bool warm = true;                                // frames had stopped getting faster when timing began
  std::vector<uint64_t> chunks_made;               // of each timed frame
  ChunkSizes chunk_sizes;
  ItemSeconds item_seconds;
  double empty_region_seconds = 0;  // a run of one empty item a thread; median
  bool shares_cache_lines = false;  // items side by side lie in one line of the film: false sharing
  double imbalance = 0;             // of the workers' busy times, frame by frame: max/mean − 1
  double log_share = 0;             // of a frame that logging the workers' times cost; 0: it was off
  double build_seconds = 0;
  RayRecord rays;
  LeftOutRecord left_out;
  std::string image_hash, scene_hash, config_hash;
  std::vector<WorkerRecord> workers;

  /// Frames a second: frames / total time, summed over processes.
  [[nodiscard]] double fps() const;
  /// Processors that its threads could use: all, or those that they were bound to.
  [[nodiscard]] int processors_to_use() const {
    return is_bound() && processors_seen > 0 ? processors_seen : machine.pus;
  }
  /// Whether each thread is bound to a processor.
  [[nodiscard]] bool is_bound() const { return pin != "none" && pin != "-"; }
};

/// Thrown for records that cannot be read: file, line, reason.
struct RecordError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

[[nodiscard]] nlohmann::json to_json(const Record& record);
[[nodiscard]] nlohmann::json state_as_json(const LaunchState& state);
/// One line of records.jsonl, without its newline. What is not UTF-8 in a name or a reason is replaced.
[[nodiscard]] std::string to_line(const Record& record);
[[nodiscard]] Record record_from_json(const nlohmann::json& json);

/// All whole records of a file, in order; a last line without its end (a writer that was killed) is left out.
/// Throws RecordError for a line that is no record, or one of another schema.
[[nodiscard]] std::vector<Record> read_records(const std::filesystem::path& file);

}  // namespace raysweep
