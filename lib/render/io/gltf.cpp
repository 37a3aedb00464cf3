#include <tiny_gltf.h>
#include <algorithm>
#include <array>
#include <cmath>

#include "lib/render/io/gltf_parts.h"
#include "lib/render/io/gltf_values.h"
#include "lib/render/io/read_scene.h"
#include "tristim/core/error.h"
#include "tristim/core/file.h"
#include "tristim/light/vector.h"
#include "tristim/render/io/model_file.h"

namespace tristim {
namespace {

using detail::GltfValues;
using Eigen::Matrix4d;
using Eigen::Vector3d;

constexpr double kDegrees = detail::kDegreesPerGltfRadian;

class GltfParser {
 public:
  GltfParser(const std::string& file, const std::string& directory)
      : file_(file), directory_(directory) {}

  ModelFile parse(std::string_view bytes) {
    load(bytes);
    result_.unit_m = 1;
    result_.materials.push_back({.name = "default", .surface = detail::kDefaultSurface});
    for (const tinygltf::Material& material : gltf_.materials) add_material(material);
    for (const tinygltf::Mesh& mesh : gltf_.meshes) add_mesh(mesh);
    visited_.resize(gltf_.nodes.size());
    if (gltf_.scenes.empty()) fail("has no scene");
    const int scene = std::max(gltf_.defaultScene, 0);
    for (const int node : at(gltf_.scenes, scene, "scene").nodes) {
      add_node(node, Matrix4d::Identity(), 0);
    }
    if (!gltf_.textures.empty()) note("textures are not drawn: the factors of the materials count");
    if (!gltf_.skins.empty() || !gltf_.animations.empty()) note("skins and animations rest");
    return std::move(result_);
  }

 private:
  [[noreturn]] void fail(const std::string& wrong, const std::string& remedy = {}) const {
    throw Error(ErrorKind::kContent, file_, wrong, remedy);
  }

  void note(const std::string& text) {
    const std::string line = file_ + ": " + text;
    if (std::find(result_.notes.begin(), result_.notes.end(), line) == result_.notes.end()) {
      result_.notes.push_back(line);
    }
  }

  // A member of a list that the file names by its number.
  template <typename List>
  const typename List::value_type& at(const List& list, int number, const char* what) const {
    if (number < 0 || static_cast<std::size_t>(number) >= list.size()) {
      fail("names " + std::string(what) + " " + std::to_string(number) + " of " +
           std::to_string(list.size()));
    }
    return list[static_cast<std::size_t>(number)];
  }

  void load(std::string_view bytes) {
    tinygltf::TinyGLTF loader;
    loader.SetImageLoader([](tinygltf::Image*, int, std::string*, std::string*, int, int,
                             const unsigned char*, int, void*) { return true; },
                          nullptr);
    loader.SetFsCallbacks({file_exists, expanded_path, read_whole_file, nullptr, this});
    const auto size = static_cast<unsigned>(bytes.size());
    std::string error;
    std::string warning;
    const bool binary = bytes.starts_with("glTF");
    bool good = false;
    try {
      good = binary ? loader.LoadBinaryFromMemory(
                          &gltf_, &error, &warning,
                          reinterpret_cast<const unsigned char*>(bytes.data()), size, directory_)
                    : loader.LoadASCIIFromString(&gltf_, &error, &warning, bytes.data(), size,
                                                 directory_);
    } catch (const Error&) {
      throw;
    } catch (const std::exception& thrown) {  // its JSON library's
      error = thrown.what();
    }
    if (good) return;
    const std::string line = error.substr(0, error.find('\n'));
    fail("is no glTF 2.0 file" + (line.empty() ? "" : ": " + line),
         "check it with the glTF validator");
  }

  static bool file_exists(const std::string&, void*) { return true; }
  static std::string expanded_path(const std::string& path, void*) { return path; }
  static bool read_whole_file(std::vector<unsigned char>* out, std::string*,
                              const std::string& path, void*) {
    constexpr std::size_t kMostBytes = std::size_t{2} << 30;
    const std::string bytes = read_text_file(path, kMostBytes);
    out->assign(bytes.begin(), bytes.end());
    return true;
  }

  GltfValues values(int number) {
    const tinygltf::Accessor& accessor = at(gltf_.accessors, number, "accessor");
    const std::string name = "accessor " + std::to_string(number);
    if (accessor.sparse.isSparse) note("sparse accessors are read without their exceptions");
    const tinygltf::BufferView& view = at(gltf_.bufferViews, accessor.bufferView, "buffer view");
    const tinygltf::Buffer& buffer = at(gltf_.buffers, view.buffer, "buffer");
    const std::size_t size = buffer.data.size();
    if (view.byteOffset > size || view.byteLength > size - view.byteOffset) {
      fail(name + " lies outside of its buffer of " + std::to_string(size) + " bytes");
    }
    GltfValues found;
    found.component_type = accessor.componentType;
    found.components =
        std::max(tinygltf::GetNumComponentsInType(static_cast<unsigned>(accessor.type)), 0);
    found.normalized = accessor.normalized;
    found.count = accessor.count;
    const std::size_t element =
        detail::component_bytes(found.component_type) * static_cast<std::size_t>(found.components);
    if (element == 0) fail(name + " has an unknown type");
    found.stride = view.byteStride != 0 ? view.byteStride : element;
    const std::size_t length = view.byteLength;
    const bool fits = accessor.byteOffset <= length && element <= length - accessor.byteOffset &&
                      (found.count == 0 ||
                       found.count - 1 <= (length - accessor.byteOffset - element) / found.stride);
    if (!fits) {
      fail(name + " has " + std::to_string(found.count) + " elements, its view " +
           std::to_string(length) + " bytes");
    }
    found.bytes = std::span(buffer.data)
                      .subspan(view.byteOffset + accessor.byteOffset, length - accessor.byteOffset);
    return found;
  }

  // An attribute of a primitive: as many elements as it has vertices, 0 where it has none.
  GltfValues attribute(const tinygltf::Primitive& primitive, const char* name, int components) {
    const auto found = primitive.attributes.find(name);
    if (found == primitive.attributes.end()) return {};
    const GltfValues all = values(found->second);
    if (all.components != components) {
      fail(std::string(name) + " has " + std::to_string(all.components) + " components, not " +
           std::to_string(components));
    }
    return all;
  }

  double finite(const GltfValues& all, std::size_t element, int component) const {
    const double value = detail::gltf_number(all, element, component);
    if (!std::isfinite(value)) {
      fail("element " + std::to_string(element) + " of an attribute is not finite");
    }
    return value;
  }

  Vector3d vector(const GltfValues& all, std::size_t i) const {
    return {finite(all, i, 0), finite(all, i, 1), finite(all, i, 2)};
  }

  void add_mesh(const tinygltf::Mesh& mesh) {
    PolygonModel& model = result_.models.emplace_back();
    for (const tinygltf::Primitive& primitive : mesh.primitives) {
      constexpr int kTriangles = 4;
      const int mode = primitive.mode < 0 ? kTriangles : primitive.mode;
      if (mode < kTriangles) {
        note("points and lines are not drawn");
      } else {
        add_primitive(primitive, mode, model);
      }
    }
  }

  void add_primitive(const tinygltf::Primitive& primitive, int mode, PolygonModel& model) {
    const GltfValues positions = attribute(primitive, "POSITION", 3);
    const GltfValues normals = attribute(primitive, "NORMAL", 3);
    const GltfValues uvs = attribute(primitive, "TEXCOORD_0", 2);
    if (positions.count > kNoIndex - model.positions.size()) fail("has too many vertices");
    const auto first_position = static_cast<std::uint32_t>(model.positions.size());
    const auto first_normal = static_cast<std::uint32_t>(model.normals.size());
    const auto first_uv = static_cast<std::uint32_t>(model.uvs.size());
    for (std::size_t i = 0; i < positions.count; ++i) {
      model.positions.push_back(vector(positions, i));
    }
    for (std::size_t i = 0; i < normals.count; ++i) model.normals.push_back(vector(normals, i));
    for (std::size_t i = 0; i < uvs.count; ++i) {
      model.uvs.push_back(
          {static_cast<float>(finite(uvs, i, 0)), static_cast<float>(finite(uvs, i, 1))});
    }
    const auto material = static_cast<std::uint32_t>(primitive.material + 1);
    if (primitive.material >= 0) (void)at(gltf_.materials, primitive.material, "material");
    const std::vector<std::uint32_t> corners =
        detail::triangle_corners(indices_of(primitive, positions.count), mode);
    for (std::size_t i = 0; i < corners.size(); i += 3) {
      std::array<MeshCorner, 3> triangle;
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t vertex = corners[i + k];
        triangle[k].position = first_position + vertex;
        const bool has_normal =
            vertex < normals.count && model.normals[first_normal + vertex] != Vector3d(0, 0, 0);
        if (has_normal) triangle[k].normal = first_normal + vertex;
        if (vertex < uvs.count) triangle[k].uv = first_uv + vertex;
      }
      add_face(model, triangle, primitive.material < 0 ? 0 : material);
    }
  }

  std::vector<std::uint32_t> indices_of(const tinygltf::Primitive& primitive, std::size_t count) {
    std::vector<std::uint32_t> indices;
    if (primitive.indices < 0) {
      for (std::size_t i = 0; i < count; ++i) indices.push_back(static_cast<std::uint32_t>(i));
      return indices;
    }
    const GltfValues all = values(primitive.indices);
    if (all.components != 1 || all.component_type == 5126) fail("indices are no whole numbers");
    for (std::size_t i = 0; i < all.count; ++i) {
      indices.push_back(detail::gltf_index(all, i));
      if (indices.back() >= count) {
        fail("index " + std::to_string(i) + " names vertex " + std::to_string(indices.back()) +
             " of " + std::to_string(count));
      }
    }
    return indices;
  }

  void add_material(const tinygltf::Material& from) {
    const tinygltf::PbrMetallicRoughness& pbr = from.pbrMetallicRoughness;
    if (pbr.baseColorFactor.size() != 4) fail("baseColorFactor has not 4 numbers");
    detail::MetallicRoughness factors{.metallic = pbr.metallicFactor,
                                      .roughness = pbr.roughnessFactor,
                                      .blended = from.alphaMode == "BLEND"};
    std::copy(pbr.baseColorFactor.begin(), pbr.baseColorFactor.end(), factors.base.begin());
    SceneMaterial material = detail::metallic_material(factors);
    material.name = from.name;
    material.two_sided = from.doubleSided;
    result_.materials.push_back(material);
  }

  Matrix4d placement_of(const tinygltf::Node& node) const {
    const Matrix4d placement =
        detail::node_placement(node.matrix, node.translation, node.rotation, node.scale);
    if (!placement.allFinite()) fail("node '" + node.name + "' is not placed in finite numbers");
    return placement;
  }

  void add_node(int number, const Matrix4d& parent, int depth) {
    constexpr int kDeepest = 1000;
    const tinygltf::Node& node = at(gltf_.nodes, number, "node");
    if (visited_[static_cast<std::size_t>(number)] || depth > kDeepest) {
      fail("node " + std::to_string(number) + " has two parents", "give each its own");
    }
    visited_[static_cast<std::size_t>(number)] = true;
    const Matrix4d world = parent * placement_of(node);
    if (node.mesh >= 0) {
      (void)at(gltf_.meshes, node.mesh, "mesh");
      result_.placed.push_back({node.name, static_cast<std::size_t>(node.mesh), world});
    }
    if (node.camera >= 0 && !result_.camera) {
      result_.camera = camera_of(at(gltf_.cameras, node.camera, "camera"), world);
    }
    const auto light = node.extensions.find("KHR_lights_punctual");
    if (light != node.extensions.end() && light->second.Has("light")) {
      const int which = light->second.Get("light").GetNumberAsInt();
      add_light(at(gltf_.lights, which, "light"), world);
    }
    for (const int child : node.children) add_node(child, world, depth + 1);
  }

  static Vector3d direction(const Matrix4d& world, const Vector3d& v) {
    return normalize(world.topLeftCorner<3, 3>() * v);
  }

  Camera camera_of(const tinygltf::Camera& from, const Matrix4d& world) {
    Camera camera;
    camera.eye = world.topRightCorner<3, 1>();
    camera.target = camera.eye + direction(world, {0, 0, -1});
    camera.up = direction(world, {0, 1, 0});
    camera.orthographic = from.type == "orthographic";
    const double near = camera.orthographic ? from.orthographic.znear : from.perspective.znear;
    const double far = camera.orthographic ? from.orthographic.zfar : from.perspective.zfar;
    if (near > 0 && std::isfinite(near)) camera.near = near;
    if (far > camera.near) camera.far = far;
    if (camera.orthographic) {
      camera.height = 2 * from.orthographic.ymag;
      if (!(camera.height > 0))
        fail("camera '" + from.name + "' sees nothing: ymag is not above 0");
    } else {
      camera.fov_deg = from.perspective.yfov * kDegrees;
      if (!(camera.fov_deg > 0 && camera.fov_deg < 180)) {
        fail("camera '" + from.name + "' has a yfov out of range");
      }
    }
    return camera;
  }

  void add_light(const tinygltf::Light& from, const Matrix4d& world) {
    Rgb color{1, 1, 1};
    if (from.color.size() == 3) color = {from.color[0], from.color[1], from.color[2]};
    const Rgb intensity{from.intensity * color.r, from.intensity * color.g,
                        from.intensity * color.b};
    const Attenuation falling{.kind = *find_by_name(kAttenuations, "inverse_square")};
    const Vector3d position = world.topRightCorner<3, 1>();
    const Vector3d forward = direction(world, {0, 0, -1});
    SceneLight light{.name = from.name};
    if (from.type == "directional") {
      light.source = DirectionalLight{-forward, intensity};
    } else if (from.type == "point") {
      light.source = PointLight{position, intensity, falling};
    } else if (from.type == "spot") {
      const double inner = from.spot.innerConeAngle;
      const double outer = from.spot.outerConeAngle;
      light.source =
          SpotLight{position,  forward, outer * kDegrees, detail::spot_exponent(inner, outer),
                    intensity, falling};
    } else {
      fail("light '" + from.name + "' has the unknown type '" + from.type + "'");
    }
    result_.lights.push_back(light);
  }

  const std::string& file_;
  const std::string& directory_;
  tinygltf::Model gltf_;
  ModelFile result_;
  std::vector<bool> visited_;
};

}  // namespace

ModelFile parse_gltf(std::string_view bytes, const std::string& file,
                     const std::string& directory) {
  return GltfParser(file, directory).parse(bytes);
}

}  // namespace tristim
