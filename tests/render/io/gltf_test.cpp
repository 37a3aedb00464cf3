#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "tests/error_text.h"
#include "tests/support.h"
#include "tristim/render/io/model_file.h"
#include "tristim/render/io/scene_file.h"
#include "tristim/render/mesh_normals.h"

namespace tristim {
namespace {

using Json = nlohmann::json;

template <typename T>
void append(std::string& bytes, std::initializer_list<T> values) {
  for (const T value : values) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
}

// A square in the x-y plane: positions (48 bytes), normals (48), two triangles' indices (12).
std::string square_bytes() {
  std::string bytes;
  append<float>(bytes, {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0});
  append<float>(bytes, {0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1});
  append<std::uint16_t>(bytes, {0, 1, 2, 0, 2, 3});
  return bytes;
}

Json square() {
  return Json::parse(R"({
    "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0, 2, 3]}],
    "nodes": [{"translation": [0, 0, 5], "rotation": [0, 0, 0.70710678118654752, 0.70710678118654752],
               "children": [1], "name": "turned"},
              {"mesh": 0, "scale": [2, 1, 1]},
              {"camera": 0, "translation": [0, 0, 9]},
              {"extensions": {"KHR_lights_punctual": {"light": 0}}, "translation": [1, 2, 3]}],
    "cameras": [{"type": "perspective", "perspective": {"yfov": 1.0, "znear": 0.25, "zfar": 50}}],
    "extensionsUsed": ["KHR_lights_punctual"],
    "extensions": {"KHR_lights_punctual": {"lights": [
      {"type": "spot", "name": "lamp", "color": [1, 0.5, 0], "intensity": 8,
       "spot": {"innerConeAngle": 0.2, "outerConeAngle": 0.6}}]}},
    "materials": [{"name": "red", "doubleSided": true, "alphaMode": "BLEND",
      "pbrMetallicRoughness": {"baseColorFactor": [0.8, 0.1, 0, 0.25], "metallicFactor": 0,
                               "roughnessFactor": 0.5}}],
    "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "NORMAL": 1}, "indices": 2,
                                "material": 0}]}],
    "accessors": [
      {"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3"},
      {"bufferView": 1, "componentType": 5126, "count": 4, "type": "VEC3"},
      {"bufferView": 2, "componentType": 5123, "count": 6, "type": "SCALAR"}],
    "bufferViews": [{"buffer": 0, "byteOffset": 0, "byteLength": 48},
                    {"buffer": 0, "byteOffset": 48, "byteLength": 48},
                    {"buffer": 0, "byteOffset": 96, "byteLength": 12}],
    "buffers": [{"uri": "square.bin", "byteLength": 108}]
  })");
}

// The same file as one: GLB.
std::string glb(Json json, std::string bytes) {
  json["buffers"][0].erase("uri");
  std::string text = json.dump();
  text.resize((text.size() + 3) / 4 * 4, ' ');
  bytes.resize((bytes.size() + 3) / 4 * 4, '\0');
  std::string file = "glTF";
  const auto total = static_cast<std::uint32_t>(12 + 8 + text.size() + 8 + bytes.size());
  append<std::uint32_t>(file, {2, total, static_cast<std::uint32_t>(text.size()), 0x4E4F534A});
  file += text;
  append<std::uint32_t>(file, {static_cast<std::uint32_t>(bytes.size()), 0x004E4942});
  return file + bytes;
}

ModelFile parsed(const Json& json, const std::string& bytes = square_bytes()) {
  return parse_gltf(glb(json, bytes), "m.glb", "/nowhere");
}

std::string error_of(const Json& json, const std::string& bytes = square_bytes()) {
  return error_text([&] { (void)parsed(json, bytes); });
}

void expect_square(const ModelFile& file) {
  ASSERT_EQ(file.models.size(), 1U);
  ASSERT_EQ(file.models[0].faces.size(), 2U);
  EXPECT_EQ(file.models[0].positions[2], Eigen::Vector3d(1, 1, 0));
  EXPECT_EQ(file.models[0].corners[4], (MeshCorner{2, 2, kNoIndex}));
  EXPECT_TRUE(has_normals(file.models[0]));
  EXPECT_EQ(file.models[0].faces[1].material, 1U);
  ASSERT_EQ(file.placed.size(), 1U);
  // (1, 1, 0): scaled in the child, then turned by 90 degrees about z, then moved.
  const Eigen::Vector4d moved = file.placed[0].world_from_model * Eigen::Vector4d(1, 1, 0, 1);
  EXPECT_NEAR((moved - Eigen::Vector4d(-1, 2, 5, 1)).norm(), 0, 1e-15);
}

TEST(Gltf, TextWithItsBufferBesideIt) {
  const TemporaryDirectory folder;
  write_bytes(folder.file("square.bin"), square_bytes());
  write_bytes(folder.file("square.gltf"), square().dump());
  expect_square(read_model_file(folder.file("square.gltf")));
  EXPECT_EQ(error_text([&] { (void)parse_gltf(square().dump(), "x.gltf", "/nowhere"); }),
            "1 /nowhere/square.bin: there is no such file; check the name");
}

TEST(Gltf, BinaryInOneFile) { expect_square(parsed(square())); }

TEST(Gltf, CamerasLightsAndMaterials) {
  const ModelFile file = parsed(square());
  ASSERT_TRUE(file.camera.has_value());
  EXPECT_EQ(file.camera->eye, Eigen::Vector3d(0, 0, 9));
  EXPECT_EQ(file.camera->target, Eigen::Vector3d(0, 0, 8));
  EXPECT_NEAR(file.camera->fov_deg, 57.29577951308232, 1e-13);
  EXPECT_EQ(file.camera->near, 0.25);
  EXPECT_EQ(file.camera->far, 50);
  ASSERT_EQ(file.lights.size(), 1U);
  const auto& spot = std::get<SpotLight>(file.lights[0].source);
  EXPECT_EQ(spot.position, Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(spot.direction, Eigen::Vector3d(0, 0, -1));
  EXPECT_EQ(spot.intensity, (Rgb{8, 4, 0}));
  EXPECT_NEAR(spot.cutoff_deg, 34.37746770784939, 1e-13);
  EXPECT_NEAR(std::pow(std::cos(0.4), spot.exponent), 0.5, 1e-14);
  EXPECT_EQ(spot.attenuation.kind.name, "inverse_square");
  const SceneMaterial& red = file.materials.at(1);
  EXPECT_EQ(red.model.name, kMicrofacetReflection.name);
  EXPECT_EQ(red.surface.od, (Rgb{0.8, 0.1, 0}));
  EXPECT_EQ(red.surface.kd, 1);
  EXPECT_EQ(red.rough.facets.m, 0.25);
  EXPECT_NEAR(fresnel(red.rough.reflectors[0], 1), 0.04, 1e-15);
  EXPECT_EQ(red.transparent.kt, 0.75);
  EXPECT_TRUE(red.two_sided);
  Json metal = square();
  metal["materials"][0]["pbrMetallicRoughness"]["metallicFactor"] = 1;
  const SceneMaterial gold = parsed(metal).materials.at(1);
  EXPECT_EQ(gold.surface.kd, 0);
  EXPECT_NEAR(fresnel(gold.rough.reflectors[0], 1), 0.8, 1e-14);
}

TEST(Gltf, StripsFansAndNoIndices) {
  Json json = square();
  json["meshes"][0]["primitives"][0].erase("indices");
  json["meshes"][0]["primitives"][0]["mode"] = 6;
  const PolygonModel fan = parsed(json).models[0];
  ASSERT_EQ(fan.faces.size(), 2U);
  EXPECT_EQ(fan.corners[3].position, 0U);
  EXPECT_EQ(fan.corners[5].position, 3U);
  json["meshes"][0]["primitives"][0]["mode"] = 5;
  const PolygonModel strip = parsed(json).models[0];
  EXPECT_EQ(strip.corners[3].position, 1U);
  EXPECT_EQ(strip.corners[4].position, 3U);
  EXPECT_EQ(strip.corners[5].position, 2U);
  json["meshes"][0]["primitives"][0]["mode"] = 1;
  const ModelFile lines = parsed(json);
  EXPECT_TRUE(lines.models[0].faces.empty());
  EXPECT_EQ(lines.notes, std::vector<std::string>{"m.glb: points and lines are not drawn"});
}

TEST(Gltf, RefusesWhatIsNotThere) {
  const auto changed = [](const std::string& pointer, const Json& value) {
    Json json = square();
    json[Json::json_pointer(pointer)] = value;
    return error_of(json);
  };
  EXPECT_EQ(changed("/accessors/0/count", 5),
            "3 m.glb: accessor 0 has 5 elements, its view 48 bytes");
  EXPECT_EQ(changed("/accessors/0/count", 4398046511104),
            "3 m.glb: accessor 0 has 4398046511104 elements, its view 48 bytes");
  EXPECT_EQ(changed("/accessors/0/byteOffset", 49),
            "3 m.glb: accessor 0 has 4 elements, its view 48 bytes");
  EXPECT_EQ(changed("/bufferViews/0/byteLength", 1000),
            "3 m.glb: accessor 0 lies outside of its buffer of 108 bytes");
  EXPECT_EQ(changed("/meshes/0/primitives/0/attributes/POSITION", 7),
            "3 m.glb: names accessor 7 of 3");
  EXPECT_EQ(changed("/meshes/0/primitives/0/material", 3), "3 m.glb: names material 3 of 1");
  EXPECT_EQ(changed("/nodes/1/mesh", 3), "3 m.glb: names mesh 3 of 1");
  EXPECT_EQ(changed("/nodes/1/children", {0}),
            "3 m.glb: node 0 has two parents; give each its own");
  EXPECT_EQ(changed("/nodes/0/children", {8}), "3 m.glb: names node 8 of 4");
  EXPECT_EQ(changed("/accessors/2/componentType", 5126),
            "3 m.glb: accessor 2 has 6 elements, its view 12 bytes");
  EXPECT_EQ(changed("/accessors/0/type", "VEC2"), "3 m.glb: POSITION has 2 components, not 3");
  std::string bytes = square_bytes();
  bytes[96] = 9;
  EXPECT_EQ(error_of(square(), bytes), "3 m.glb: index 0 names vertex 9 of 4");
  bytes = square_bytes();
  bytes[2] = bytes[3] = '\x7f';  // a NaN
  bytes[2] = '\xc0';
  EXPECT_EQ(error_of(square(), bytes), "3 m.glb: element 0 of an attribute is not finite");
}

TEST(Gltf, DamagedFilesAreErrors) {
  const std::string whole = glb(square(), square_bytes());
  for (std::size_t size = 0; size < whole.size(); size += 7) {
    EXPECT_NE(error_text([&] { (void)parse_gltf(whole.substr(0, size), "m.glb", "/nowhere"); }), "")
        << size;
  }
  for (std::size_t i = 0; i < whole.size(); i += 3) {
    std::string damaged = whole;
    damaged[i] = static_cast<char>(damaged[i] ^ 0x55);
    (void)error_text([&] { (void)parse_gltf(damaged, "m.glb", "/nowhere"); });
  }
  for (const std::string& text : {std::string(), std::string("{}"), std::string("[]"),
                                  std::string("{\"asset\":{\"version\":\"2.0\"}}")}) {
    EXPECT_EQ(error_text([&] { (void)parse_gltf(text, "m.gltf", "/nowhere"); }).substr(0, 10),
              "3 m.gltf: ");
  }
}

TEST(Gltf, InASceneOfAnotherUnit) {
  const TemporaryDirectory folder;
  write_bytes(folder.file("m.glb"), glb(square(), square_bytes()));
  write_bytes(folder.file("s.toml"), "units = \"cm\"\n[[object]]\nfile = \"m.glb\"\n");
  const Scene scene = load_scene(folder.file("s.toml")).scene;
  const Eigen::Vector4d moved = scene.objects[0].world_from_object * Eigen::Vector4d(1, 1, 0, 1);
  EXPECT_NEAR((moved - Eigen::Vector4d(-100, 200, 500, 1)).norm(), 0, 1e-12);
  const auto& spot = std::get<SpotLight>(scene.lights[0].source);
  EXPECT_EQ(spot.position, Eigen::Vector3d(100, 200, 300));
  EXPECT_NEAR(spot.intensity.r, 80000, 1e-9);  // 8 cd, over squares of centimetres
  EXPECT_EQ(scene.camera.near, 0.25 * 100);
  EXPECT_EQ(scene.camera.eye, Eigen::Vector3d(0, 0, 900));
}

}  // namespace
}  // namespace tristim
