#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tristim/render/scene.h"

namespace tristim {

/// A scene as it was read.
struct SceneFile {
  Scene scene = {};
  std::string name = {};
  std::vector<std::string> notes = {};  // what is odd or was left out, a line each
};

/// How much of everything a scene has.
struct SceneCounts {
  std::size_t objects = 0;
  std::size_t triangles = 0;   // of all objects, those without area included
  std::size_t degenerate = 0;  // of these without area: they are not drawn
  std::size_t vertices = 0;
  std::size_t materials = 0;
  std::size_t lights = 0;
};
SceneCounts count_scene(const Scene& scene) noexcept;

/// A scene from a TOML text, docs/scenes.md. `file` is for messages; paths in it are relative to
/// `directory`.
///
/// Throws Error (kContent) "<file>:<line>:<column>: ..." for what is no scene: values out of range,
/// unknown keys and names, each with a hint; and what read_model_file throws for its meshes.
SceneFile parse_scene(std::string_view text, const std::string& file, const std::string& directory);

/// A scene of luts/scenes, which is part of the library.
struct BuiltInScene {
  std::string_view name;
  std::string_view text;
};
std::span<const BuiltInScene> built_in_scenes() noexcept;

/// The scene of a built-in name or of a path: a TOML file, or a file of meshes, which gets a camera
/// that sees all of it and, where it has no lights, one that goes with the camera.
///
/// Throws Error: kSystem where it cannot be read, kMisuse for an unknown name, and what parse_scene
/// throws.
SceneFile load_scene(const std::string& name_or_path);

}  // namespace tristim
