#include "tools/scene_facts.h"

#include <nlohmann/json.hpp>

#include "tools/cli.h"
#include "tristim/core/find.h"
#include "tristim/core/text.h"
#include "tristim/render/io/model_file.h"

namespace tristim::tools {
namespace {

using Json = nlohmann::ordered_json;

Json vector_of(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

std::string words_of(const Eigen::Vector3d& v) {
  return rounded(v.x(), 6) + " " + rounded(v.y(), 6) + " " + rounded(v.z(), 6);
}

std::string counted(std::size_t count, const std::string& names) {
  return std::to_string(count) + (names.empty() ? "" : ": " + names);
}

}  // namespace

bool is_scene_file(const std::string& path) {
  return path.ends_with(".toml") || model_format_of(path) != nullptr;
}

Json scene_json(const std::string& path, const SceneFile& file) {
  const SceneCounts counts = count_scene(file.scene);
  const Camera& camera = file.scene.camera;
  return {{"file", path},
          {"name", file.name},
          {"objects", counts.objects},
          {"triangles", counts.triangles},
          {"degenerate", counts.degenerate},
          {"vertices", counts.vertices},
          {"materials", counts.materials},
          {"lights", counts.lights},
          {"width", file.scene.picture.width},
          {"height", file.scene.picture.height},
          {"camera",
           {{"eye", vector_of(camera.eye)},
            {"target", vector_of(camera.target)},
            {"orthographic", camera.orthographic},
            {"fov_deg", camera.fov_deg}}},
          {"notes", file.notes}};
}

std::string scene_text(const std::string& path, const SceneFile& file) {
  const Scene& scene = file.scene;
  const SceneCounts counts = count_scene(scene);
  std::string text = one_line(path) + "\n";
  const auto line = [&text](std::string label, const std::string& value) {
    label.resize(14, ' ');
    text += "  " + label + value + "\n";
  };
  line("scene", one_line(file.name));
  line("size", std::to_string(scene.picture.width) + "x" + std::to_string(scene.picture.height));
  line("objects", std::to_string(counts.objects));
  line("triangles", std::to_string(counts.triangles) +
                        (counts.degenerate > 0 ? ", " + std::to_string(counts.degenerate) +
                                                     " of them without area: not drawn"
                                               : ""));
  line("vertices", std::to_string(counts.vertices));
  line("materials", counted(counts.materials, one_line(list_names(scene.materials))));
  line("lights", counted(counts.lights, one_line(list_names(scene.lights))));
  line("camera", "from " + words_of(scene.camera.eye) + " to " + words_of(scene.camera.target));
  for (const std::string& note : file.notes) line("note", one_line(note));
  return text;
}

}  // namespace tristim::tools
