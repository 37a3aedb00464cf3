#pragma once

#include <optional>
#include <string>

#include "tristim/render/render.h"

namespace tristim::tools {

/// Numbers of frames, both included, of a turn of `turn` frames round the target.
struct FrameRange {
  int first = 1, last = 1, turn = 1;
};

/// `tristim render SCENE` for scenes of meshes. What is absent is as the scene has it.
struct RenderSceneOptions {
  std::string scene;
  std::string output;
  std::optional<int> width = {}, height = {};
  std::optional<int> samples = {};
  std::optional<Shading> shading = {};
  std::optional<PixelFilter> filter = {};
  bool affine = false;
  bool half = false;
  bool force = false;
  std::optional<FrameRange> frames = {};
  RenderOptions render = {};
};

/// The layers of a list of names with commas, "all" for every one. Throws Error (kMisuse).
std::vector<RenderLayer> layers_of(const std::string& text);

/// "1-24", "7", or "1-12/24" for the first half of a turn. Throws Error (kMisuse).
FrameRange frames_of(const std::string& text);

/// Throws Error, as load_scene and open_exr_sink do, and for outputs that are taken.
void render_scene_file(const RenderSceneOptions& options);

}  // namespace tristim::tools
