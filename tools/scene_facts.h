#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "tristim/render/io/scene_file.h"

namespace tristim::tools {

/// Whether a file is a scene or one of meshes by its name.
bool is_scene_file(const std::string& path);

/// What a scene holds: objects, triangles and those without area, vertices, materials, lights, the
/// camera, and what is odd about it.
nlohmann::ordered_json scene_json(const std::string& path, const SceneFile& file);
std::string scene_text(const std::string& path, const SceneFile& file);

}  // namespace tristim::tools
