// Tests that write scene and mesh files into a folder of their own.
#pragma once

#include <gtest/gtest.h>
#include <stdlib.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "tracer/scene/scene_file.h"

namespace raysweep {

/// A material and an object: the least that a scene needs.
inline const std::string material = "[materials.m]\n";
inline const std::string sphere =
    "[[objects]]\nshape = 'sphere'\ncentre = [0, 0, 0]\nradius = 1\nmaterial = 'm'\n";

class SceneFolder : public testing::Test {
 public:
  SceneFolder() {
    std::string name = std::filesystem::temp_directory_path() / "raysweep_scene_XXXXXX";
    folder = mkdtemp(name.data());
  }
  ~SceneFolder() override { std::filesystem::remove_all(folder); }

  /// Writes a file and gives its path.
  [[nodiscard]] std::string write(const std::string& name, const std::string& text) const {
    std::ofstream(folder / name, std::ios::binary) << text;
    return (folder / name).string();
  }

  [[nodiscard]] Scene load(const std::string& text) const {
    return load_scene_file(write("scene.toml", text));
  }

  /// What loading says, without the folder.
  [[nodiscard]] std::string errors(const std::string& text) const {
    return errors_of(write("scene.toml", text));
  }

  [[nodiscard]] std::string errors_of(const std::string& file) const {
    try {
      (void)load_scene_file(file);
    } catch (const SceneError& error) {
      std::string said = error.what();
      const std::string path = folder.string() + "/";
      for (size_t at = said.find(path); at != std::string::npos; at = said.find(path))
        said.erase(at, path.size());
      return said;
    }
    return "no error";
  }

  std::filesystem::path folder;
};

}  // namespace raysweep
