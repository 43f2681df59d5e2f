// One combination of factors: a row of a sweep.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "schedulers/scheduler.h"
#include "tracer/scene/scenes.h"
#include "tracer/settings.h"

namespace raysweep {

struct Cell {
  std::string scene = "chair-ball";  // a built-in name or a scene or mesh file
  std::string mode = "custom";       // whose numbers the settings started from
  RenderSettings settings;
  std::optional<int> lights;  // none: as many as the scene has; told before anything is planned or run
  std::string scheduler = "serial";
  int threads = 1;
  std::string runtime = "default";  // of schedulers that may run on several
  std::string item = "rows", order = "scanline";
  Chunk chunk;
  std::string pin = "none";             // a policy or a list of processors
  std::string wait_policy = "default";  // what idle workers do: "default", "active" or "passive"
  std::optional<int> spin_count;        // how often they look before they sleep; none: as the runtime likes
  std::string environment;              // "NAME=VALUE NAME=VALUE" for the runtime
  double slowdown = 0;                  // planted: each frame is made longer by this share of its time
  int processes = 1;                    // more than 1: so many co-running copies, for the ceiling
  int twin = 0;  // above 0: launched beside its like in each round, to learn what noise is

  /// The canonical name: `factor=value,…` over every factor. Factors that the scheduler ignores are "-", so
  /// that cells that differ only in them are one cell.
  [[nodiscard]] std::string key() const;
  /// The same over what decides the picture. Pictures of one key are equal bit for bit.
  [[nodiscard]] std::string picture_key() const;
  /// "4", "2/thread", or "-" where the scheduler has no use for a chunk.
  [[nodiscard]] std::string chunk_text() const;
  /// "libgomp", resolved, or "-" where the scheduler has no choice.
  [[nodiscard]] std::string runtime_text() const;
  /// As the factors' texts, but "-" where the scheduler has no use for them.
  [[nodiscard]] std::string pin_text() const;
  [[nodiscard]] std::string wait_policy_text() const;
  [[nodiscard]] std::string spin_count_text() const;
  [[nodiscard]] std::string environment_text() const;
  /// "2", or "scene" for as many as the scene has.
  [[nodiscard]] std::string lights_text() const;
  /// Of the core wide the one that is used, "best" resolved; of others "baseline".
  [[nodiscard]] std::string isa_text() const;
};

/// The scene's own number of lights where none was asked for. Throws SceneError.
void resolve_lights(Cell& cell);

/// The same picture and items, by `serial` alone.
[[nodiscard]] Cell serial_cell(const Cell& cell);

/// The default for whatever the scheduler ignores, and the name of the runtime that it gets.
void collapse_ignored_factors(Cell& cell);

[[nodiscard]] nlohmann::json to_json(const Cell& cell);
[[nodiscard]] Cell cell_from_json(const nlohmann::json& json);

}  // namespace raysweep
