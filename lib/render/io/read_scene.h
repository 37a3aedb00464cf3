#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lib/core/toml_values.h"
#include "tristim/render/io/model_file.h"
#include "tristim/render/io/scene_file.h"

namespace tristim::detail {

// The sections of a scene file, each read by one function; see parse_scene.

/// A colour as a file gives it, and its spectrum where it is one.
struct SceneColor {
  Rgb rgb = {};
  std::optional<SpectralColor> spectrum = {};
};

/// What spectra are seen under, and where files are.
struct SceneContext {
  std::string directory;
  SpectralColor white;                // what has Y = 1
  std::optional<double> unit_m = {};  // the scene's unit of lengths in metres, where it says so
};

/// A path that a file names: relative to the file's directory unless it begins with a slash.
std::string path_beside(const std::string& directory, const std::string& path);

/// The directory of a path, "." where it names none.
std::string directory_of(const std::string& path);

/// The colour at `key`: [r, g, b] of linear light, one number for grey, a name or "#rrggbb" of
/// encoded sRGB, the name of an illuminant, or a table that describes one of these or a reflectance
/// (docs/scenes.md); `fallback` where the key is absent.
SceneColor read_color(const TomlTable& table, std::string_view key, const SceneContext& context,
                      const Rgb& fallback);

/// The three numbers at `key`.
Eigen::Vector3d read_vector(const TomlTable& table, std::string_view key,
                            const Eigen::Vector3d& fallback);
/// The same as a direction: not (0, 0, 0).
Eigen::Vector3d read_direction(const TomlTable& table, std::string_view key,
                               const Eigen::Vector3d& fallback);

std::optional<Camera> read_camera(const TomlTable& root);
PictureSettings read_picture(const TomlTable& root);
EdgeLines read_edges(const TomlTable& root, const SceneContext& context);
std::vector<SceneLight> read_lights(const TomlTable& root, const SceneContext& context);
std::vector<SceneMaterial> read_materials(const TomlTable& root, const SceneContext& context);

/// Adds the objects, their meshes, and the materials, lights and camera of their files.
void read_objects(const TomlTable& root, const SceneContext& context, SceneFile& file,
                  std::optional<Camera>& camera);

/// Averages the normals of a model that has not all of its own: by angles, with creases at 40
/// degrees, so that what is round stays smooth.
inline constexpr double kSmoothingDeg = 40;
void complete_normals(PolygonModel& model, double smoothing_deg = kSmoothingDeg);

/// What has no material of its own.
inline constexpr Material kDefaultSurface{.ka = 0.8, .kd = 0.8, .n = 20};

/// A point under an affine transformation.
inline Eigen::Vector3d moved(const Eigen::Matrix4d& world_from_object, const Eigen::Vector3d& p) {
  return world_from_object.topLeftCorner<3, 3>() * p + world_from_object.topRightCorner<3, 1>();
}

/// A camera in front that sees all of the scene.
Camera framing_camera(const Scene& scene);

/// Adds all of a file of meshes to a scene, moved by `world_from_file`.
struct PlacedFile {
  Eigen::Matrix4d world_from_file = Eigen::Matrix4d::Identity();
  std::string name = {};
  std::optional<std::uint32_t> material = {};
  bool lights = true;
};
void add_model_file(SceneFile& file, ModelFile&& models, const PlacedFile& placed);

}  // namespace tristim::detail
