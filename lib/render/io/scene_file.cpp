#include "tristim/render/io/scene_file.h"

#include <algorithm>
#include <array>

#include "lib/core/embedded.h"
#include "lib/render/io/read_scene.h"
#include "tristim/color/illuminant.h"
#include "tristim/color/spectrum_text.h"
#include "tristim/core/error.h"
#include "tristim/core/file.h"
#include "tristim/light/spectral.h"

namespace tristim {
namespace {

using detail::SceneContext;
using detail::TomlTable;

// The white that spectra are seen under.
SpectralColor read_white(const TomlTable& root, Scene& scene) {
  const auto name = root.string("white");
  try {
    const Spectrum spectrum = parse_illuminant(name.value_or("d65"), "white").spectrum;
    const std::vector<double> values = sampled(spectrum, kSum5nm);
    SpectralColor white;
    std::copy(values.begin(), values.end(), white.at.begin());
    if (name) scene.white = white;
    return white;
  } catch (const Error&) {
    root.fail("white", "unknown illuminant '" + *name + "'", name_hint(illuminants(), *name));
  }
}

struct LengthUnit {
  std::string_view name;
  double metres;
};
constexpr std::array kLengthUnits{LengthUnit{"m", 1},       LengthUnit{"cm", 0.01},
                                  LengthUnit{"mm", 0.001},  LengthUnit{"km", 1000},
                                  LengthUnit{"in", 0.0254}, LengthUnit{"ft", 0.3048}};

std::optional<double> read_unit(const TomlTable& root) {
  if (!root.has("units")) return std::nullopt;
  return detail::choice(root, "units", kLengthUnits, kLengthUnits[0]).metres;
}

bool shines(const Scene& scene) {
  const bool ambient = scene.ambient != Rgb{} || scene.ambient_spectrum;
  const auto is_color = [](const SceneMaterial& material) {
    return material.model.name == kFlatColor.name;
  };
  return ambient || !scene.lights.empty() ||
         std::any_of(scene.materials.begin(), scene.materials.end(), is_color);
}

void add_notes(SceneFile& file) {
  const SceneCounts counts = count_scene(file.scene);
  if (counts.triangles == 0) file.notes.push_back("there is nothing to see: add an [[object]]");
  if (!shines(file.scene)) {
    file.notes.push_back("there is no light: the picture is black; add a [[light]] or ambient");
  }
  if (counts.degenerate > 0) {
    file.notes.push_back(std::to_string(counts.degenerate) + " of " +
                         std::to_string(counts.triangles) +
                         " triangles have no area and are not drawn");
  }
}

// A scene of one file of meshes.
SceneFile scene_of(ModelFile&& models, const std::string& path) {
  SceneFile file;
  file.name = path;
  std::optional<Camera> camera = models.camera;
  for (PolygonModel& model : models.models) detail::complete_normals(model);
  detail::add_model_file(file, std::move(models), {.name = "model"});
  file.scene.camera = camera ? *camera : detail::framing_camera(file.scene);
  if (file.scene.lights.empty()) {
    file.scene.ambient = {0.1, 0.1, 0.1};
    file.scene.lights.push_back({.name = "camera",
                                 .source = DirectionalLight{{0.3, 0.5, 1}, {1, 1, 1}},
                                 .with_camera = true});
  }
  add_notes(file);
  return file;
}

}  // namespace

std::string detail::directory_of(const std::string& path) {
  const std::size_t slash = path.rfind('/');
  return slash == std::string::npos ? "." : slash == 0 ? "/." : path.substr(0, slash);
}

std::string detail::path_beside(const std::string& directory, const std::string& path) {
  return path.starts_with('/') || directory.empty() ? path : directory + "/" + path;
}

SceneCounts count_scene(const Scene& scene) noexcept {
  SceneCounts counts{.objects = scene.objects.size(),
                     .materials = scene.materials.size(),
                     .lights = scene.lights.size()};
  std::vector<std::size_t> degenerate;
  for (const Mesh& mesh : scene.meshes) {
    degenerate.push_back(degenerate_count(mesh));
    counts.vertices += mesh.positions.size();
  }
  for (const SceneObject& object : scene.objects) {
    counts.triangles += scene.meshes[object.mesh].triangles.size();
    counts.degenerate += degenerate[object.mesh];
  }
  return counts;
}

SceneFile parse_scene(std::string_view text, const std::string& file,
                      const std::string& directory) {
  const TomlTable root = TomlTable::parse(text, file);
  SceneFile read;
  Scene& scene = read.scene;
  read.name = root.string("name").value_or(file);
  (void)root.string("source");
  const SceneContext context{directory, read_white(root, scene), read_unit(root)};
  const detail::SceneColor ambient = detail::read_color(root, "ambient", context, {0, 0, 0});
  scene.ambient = ambient.rgb;
  scene.ambient_spectrum = ambient.spectrum;
  scene.picture = detail::read_picture(root);
  scene.edges = detail::read_edges(root, context);
  scene.lights = detail::read_lights(root, context);
  scene.materials = detail::read_materials(root, context);
  std::optional<Camera> camera = detail::read_camera(root);
  detail::read_objects(root, context, read, camera);
  root.finish();
  scene.camera = camera ? *camera : detail::framing_camera(scene);
  add_notes(read);
  return read;
}

std::span<const BuiltInScene> built_in_scenes() noexcept {
  static const std::vector<BuiltInScene> scenes = [] {
    std::vector<BuiltInScene> all;
    for (const detail::EmbeddedFile& file : detail::embedded_scenes()) {
      all.push_back({file.name, file.text});
    }
    return all;
  }();
  return scenes;
}

SceneFile load_scene(const std::string& name_or_path) {
  if (const auto* built_in = find_by_name(built_in_scenes(), name_or_path)) {
    return parse_scene(built_in->text, std::string(built_in->name) + ".toml", "");
  }
  if (model_format_of(name_or_path) != nullptr) {
    return scene_of(read_model_file(name_or_path), name_or_path);
  }
  const bool is_path = name_or_path == "-" || name_or_path.find('/') != std::string::npos ||
                       name_or_path.ends_with(".toml");
  if (!is_path) {
    throw Error(ErrorKind::kMisuse, name_or_path, "unknown scene",
                name_hint(built_in_scenes(), name_or_path) + " (a file of your own: ./scene.toml)");
  }
  return parse_scene(read_text_file(name_or_path), name_or_path,
                     detail::directory_of(name_or_path));
}

}  // namespace tristim
