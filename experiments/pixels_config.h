// An experiment of the kind "pixels" as its file states it, and what it asks for.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "experiments/claims_config.h"
#include "tracer/settings.h"

namespace raysweep {

struct PixelsSettings {
  std::string experiment;
  double scale = 0.5;    // of the modes' width and height
  int rounds = 7;        // fewer than six have no interval
  double seconds = 0.1;  // of a cell in a round, and one frame at least
  // Samples a pixel of the reference, in Sobol's sequence; 0: it has the mode's, in the usual pattern.
  int reference_subpixels = 0;
  uint64_t seed = 1;  // of the order in rounds
};

/// One way to make a picture: names as the command line has them.
struct PixelsSubject {
  std::string core, method, precision;
  std::string pattern{};  // empty: the one that pictures have without a word
  int subpixels = 0;      // samples a pixel; 0: the mode's
};

/// One picture, and all that make it.
struct PixelsGroup {
  std::string scene, mode;  // the scene's name or file, as the config has it
  std::string scene_file;   // what to load: from the config's folder
  double offset = 0;        // how far it is moved along each axis
  std::vector<PixelsSubject> subjects{};
};

struct PixelsConfig {
  std::string file, text;  // text as run: with what --set changed
  std::string title;
  PixelsSettings settings;
  std::vector<PixelsGroup> groups;    // scene by scene, offset by offset, mode by mode
  std::vector<std::string> left_out;  // subjects that do not exist, each with its reason
  ClaimsConfig claims{};

  [[nodiscard]] size_t cell_count() const;
};

/// "studio+10000/low"
[[nodiscard]] std::string group_key(const PixelsGroup& group);

/// "studio+10000/low/scalar/moller_trumbore/float"; with a pattern or samples of its own ".../circle/4"
[[nodiscard]] std::string cell_key(const PixelsGroup& group, const PixelsSubject& subject);

/// Whether a config is of this kind. Throws RequestError for what is no TOML.
[[nodiscard]] bool is_pixels(const std::string& text, const std::string& file,
                             const std::vector<std::string>& overrides);

/// Without [sweep]: the scene "studio" where it is, in the mode "low", by all methods, cores and precisions.
/// A sweep of patterns or samples is against a reference of 1024 samples a pixel, if it names no other.
/// Throws RequestError with one line per error.
[[nodiscard]] PixelsConfig parse_pixels_config(const std::string& text, const std::string& file,
                                               const std::vector<std::string>& overrides);

/// plan.json: the key of every cell, in order; what is left out and why; how it is measured.
[[nodiscard]] nlohmann::json to_json(const PixelsConfig& config);

}  // namespace raysweep
