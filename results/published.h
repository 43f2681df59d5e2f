// What papers printed, to hold our numbers against.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace raysweep {

/// fps with many threads by fps with few, in one mode.
struct PublishedYield {
  std::string mode;
  double yield;
};

/// fps by threads, in one mode.
struct PublishedFps {
  std::string mode;
  std::map<int, double> by_threads;
};

/// From a table of fps as below, in the order of its columns. Throws RecordError for a file that is no such
/// table.
[[nodiscard]] std::vector<PublishedFps> published_fps(const std::filesystem::path& file);

/// From a table of fps, "threads,MODE,MODE,…" and one line a thread count, in the order of its columns.
/// Throws RecordError for a file that is no such table, or has not both thread counts.
[[nodiscard]] std::vector<PublishedYield> published_yields(const std::filesystem::path& file, int few_threads,
                                                           int many_threads);

}  // namespace raysweep
