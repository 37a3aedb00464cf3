#pragma once

#include "tristim/render/scene.h"

namespace tristim::detail {

/// Throws std::invalid_argument for numbers of materials, lights and the picture that are out of
/// range or not finite; meshes, objects and the camera are checked where they are used.
void check_scene(const Scene& scene);

}  // namespace tristim::detail
