#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tristim/render/polygon_model.h"
#include "tristim/render/scene.h"

namespace tristim {

/// A model of a file where the file puts it.
struct PlacedModel {
  std::string name = {};
  std::size_t model = 0;  // of the file's
  Eigen::Matrix4d world_from_model = Eigen::Matrix4d::Identity();
};

/// What a file of meshes holds. Materials of faces are numbers of its own list, which has at least
/// one member.
struct ModelFile {
  std::vector<PolygonModel> models = {};
  std::vector<PlacedModel> placed = {};
  std::vector<SceneMaterial> materials = {};
  std::vector<SceneLight> lights = {};  // glTF: KHR_lights_punctual
  std::optional<Camera> camera = {};    // glTF: the first one that a node has
  std::optional<double> unit_m = {};    // the unit of lengths in metres, where the format has one
  std::vector<std::string> notes = {};  // what was left out, for people: "<file>: ..."
};

/// A format of files of meshes.
struct ModelFormat {
  std::string_view name;
  std::string_view extensions;  // separated by spaces
  std::string_view source;
  ModelFile (*parse)(std::string_view bytes, const std::string& file, const std::string& directory);
};

/// Every format. The scene reader, the docs and the tests read this list.
std::span<const ModelFormat> model_formats() noexcept;

/// The format of a file by the end of its name; nullptr for others.
const ModelFormat* model_format_of(std::string_view path) noexcept;

/// Wavefront OBJ: v, vt, vn, f with polygons of up to 1024 corners and relative numbers, usemtl,
/// mtllib; lines, points and curves are left out. Materials are those of MTL files in `directory`:
/// Kd, Ks, Ka (as ka, its part of Kd), Ns, d or Tr, illum; a file that is missing is a note, and
/// its materials are the first of the list, grey. Faces of less than three corners are counted in a
/// note.
///
/// Throws Error (kContent) "<file>:<line>: ..." for numbers that are not finite or none, corners
/// that name what is not there, polygons of more corners.
ModelFile parse_obj(std::string_view bytes, const std::string& file, const std::string& directory);

/// glTF 2.0 [GLTF2], text with its buffers beside it or inside, or GLB: triangles, strips and fans
/// of all scenes' first, with the transformations of their nodes; metallic-roughness materials by
/// their factors as Cook-Torrance; KHR_lights_punctual; cameras. Left out with a note: textures,
/// skins, animations, sparse accessors, points and lines.
///
/// Throws Error (kContent) "<file>: ..." for what is no glTF, buffers that are missing or too
/// short, numbers of what is not there.
ModelFile parse_gltf(std::string_view bytes, const std::string& file, const std::string& directory);

/// The file's models. Throws Error: kSystem where it cannot be read, kMisuse for an unknown
/// extension, and what the format's parser throws.
ModelFile read_model_file(const std::string& path);

}  // namespace tristim
