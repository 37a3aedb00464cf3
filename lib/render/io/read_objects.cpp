#include <algorithm>
#include <array>
#include <utility>

#include "lib/core/trigonometry.h"
#include "lib/light/product.h"
#include "lib/render/io/read_scene.h"
#include "tristim/core/error.h"
#include "tristim/core/text.h"
#include "tristim/light/vector.h"
#include "tristim/render/mesh_normals.h"
#include "tristim/render/shapes.h"

namespace tristim::detail {
namespace {

using Eigen::Matrix4d;
using Eigen::Vector3d;

// Where the normals of an object come from: its file, its faces, or a weighting of averages.
struct NormalChoice {
  std::string_view name;
  const NormalWeighting* weighting;  // nullptr: none
};
constexpr NormalChoice kGiven{"given", nullptr};
constexpr NormalChoice kFace{"face", nullptr};

std::span<const NormalChoice> normal_choices() {
  static const std::vector<NormalChoice> choices = [] {
    std::vector<NormalChoice> all{kGiven, kFace};
    for (const NormalWeighting& weighting : kNormalWeightings) {
      all.push_back({weighting.name, &weighting});
    }
    return all;
  }();
  return choices;
}

struct NormalSettings {
  NormalChoice choice = kGiven;
  double smoothing_deg = 180;
};

NormalSettings read_normals(const TomlTable& table) {
  NormalSettings settings;
  settings.choice = choice(table, "normals", normal_choices(), kGiven);
  const bool given = settings.choice.name == kGiven.name;
  settings.smoothing_deg =
      number_in(table, "smoothing_deg", given ? kSmoothingDeg : 180, 0, 180, "from 0 to 180");
  return settings;
}

void set_normals(const TomlTable& table, const NormalSettings& settings, PolygonModel& model) {
  if (settings.choice.name == kFace.name) {
    drop_normals(model);
  } else if (settings.choice.weighting != nullptr) {
    if (settings.choice.weighting->name == kPlaneNormals.name && model.planes.empty()) {
      table.fail("normals", "only the pyramid has planes", "use uniform, area or angle");
    }
    average_normals(model, *settings.choice.weighting, settings.smoothing_deg);
  } else {
    complete_normals(model, settings.smoothing_deg);
  }
}

Eigen::Matrix3d rotation_about(int axis, double angle_deg) {
  const SineCosine angle = sine_cosine_deg(angle_deg);
  const int u = (axis + 1) % 3;
  const int v = (axis + 2) % 3;
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  rotation(u, u) = rotation(v, v) = angle.cosine;
  rotation(v, u) = angle.sine;
  rotation(u, v) = -angle.sine;
  return rotation;
}

Vector3d read_scale(const TomlTable& table) {
  Vector3d scale(1, 1, 1);
  if (table.is_array("scale")) {
    scale = read_vector(table, "scale", scale);
  } else if (const auto all = table.number("scale")) {
    scale = {*all, *all, *all};
  }
  for (const double part : scale) {
    if (part == 0) table.fail("scale", "scale is 0", "give a factor");
  }
  return scale;
}

// Scaled, then turned about x, y and z, then moved.
Matrix4d read_placement(const TomlTable& table) {
  const Vector3d turns = read_vector(table, "rotate_deg", {0, 0, 0});
  const Eigen::Matrix3d turned =
      rotation_about(2, turns.z()) * (rotation_about(1, turns.y()) * rotation_about(0, turns.x()));
  Matrix4d placement = Matrix4d::Identity();
  placement.topLeftCorner<3, 3>() = turned * read_scale(table).asDiagonal();
  placement.topRightCorner<3, 1>() = read_vector(table, "translate", {0, 0, 0});
  return placement;
}

// Which of the scene's materials an object asks for by name.
std::optional<std::uint32_t> read_material_name(const TomlTable& table, const Scene& scene) {
  const auto name = table.string("material");
  if (!name) return std::nullopt;
  const SceneMaterial* found = find_by_name(scene.materials, *name);
  if (found == nullptr) {
    table.fail("material", "unknown material '" + *name + "'",
               scene.materials.empty() ? "add a [[material]] of that name"
                                       : name_hint(scene.materials, *name));
  }
  return static_cast<std::uint32_t>(found - scene.materials.data());
}

PolygonModel read_shape(const TomlTable& table) {
  const Shape shape = choice(table, "shape", shapes(), shapes()[0]);
  std::vector<double> values;
  for (const ShapeParameter& parameter : shape.parameters) {
    if (parameter.whole) (void)table.integer(parameter.name);
    values.push_back(
        number_in(table, parameter.name, parameter.preset, parameter.least, parameter.most,
                  "from " + shortest(parameter.least) + " to " + shortest(parameter.most)));
  }
  return shape.make(values);
}

ModelFile read_models(const TomlTable& table, const SceneContext& context) {
  const std::string path = path_beside(context.directory, *table.string("file"));
  try {
    return read_model_file(path);
  } catch (const Error& error) {
    if (error.kind() == ErrorKind::kContent) throw;  // it names the place in that file
    table.fail("file", error.what());
  }
}

// A camera of a file, moved with it; its near and far plane by the scale along its view.
Camera moved_camera(Camera camera, const Matrix4d& world_from_file) {
  const Vector3d view = camera.target - camera.eye;
  camera.eye = moved(world_from_file, camera.eye);
  camera.target = moved(world_from_file, camera.target);
  camera.up = world_from_file.topLeftCorner<3, 3>() * camera.up;
  const double scale = length(camera.target - camera.eye) / length(view);
  camera.near *= scale;
  camera.far *= scale;
  camera.height *= scale;
  return camera;
}

// Brings the lengths of a file to the scene's unit. The light of a place falls with the square of
// the distance, which is counted in the new unit.
void change_unit(ModelFile& models, PlacedFile& placed, double factor) {
  placed.world_from_file.topLeftCorner<3, 3>() *= factor;
  for (SceneLight& light : models.lights) {
    if (auto* point = std::get_if<PointLight>(&light.source)) {
      point->intensity = product(factor * factor, point->intensity);
    } else if (auto* spot = std::get_if<SpotLight>(&light.source)) {
      spot->intensity = product(factor * factor, spot->intensity);
    }
  }
}

void read_object(const TomlTable& table, const SceneContext& context, SceneFile& file,
                 std::optional<Camera>& camera) {
  if (table.has("file") == table.has("shape")) {
    table.fail("file", "an object must say once what it is",
               "give one of file and shape, a shape being one of: " + list_names(shapes()));
  }
  PlacedFile placed{.world_from_file = read_placement(table),
                    .name = table.string("name").value_or(
                        "object" + std::to_string(file.scene.objects.size() + 1)),
                    .material = read_material_name(table, file.scene)};
  ModelFile models;
  if (table.has("file")) {
    models = read_models(table, context);
    if (models.unit_m && context.unit_m)
      change_unit(models, placed, *models.unit_m / *context.unit_m);
    placed.lights = table.boolean("lights").value_or(true);
    if (models.camera && !camera) camera = moved_camera(*models.camera, placed.world_from_file);
  } else {
    models.models.push_back(read_shape(table));
    models.placed.push_back({});
    models.materials.push_back({.name = "default", .surface = kDefaultSurface});
  }
  const NormalSettings normals = read_normals(table);
  for (PolygonModel& model : models.models) set_normals(table, normals, model);
  table.finish();
  add_model_file(file, std::move(models), placed);
}

// A light of a file, moved with it.
SceneLight moved_light(SceneLight light, const Matrix4d& world_from_file) {
  const auto direction = [&](const Vector3d& v) -> Vector3d {
    return world_from_file.topLeftCorner<3, 3>() * v;
  };
  if (auto* far = std::get_if<DirectionalLight>(&light.source)) {
    far->to_light = direction(far->to_light);
  } else if (auto* point = std::get_if<PointLight>(&light.source)) {
    point->position = moved(world_from_file, point->position);
  } else if (auto* spot = std::get_if<SpotLight>(&light.source)) {
    spot->position = moved(world_from_file, spot->position);
    spot->direction = direction(spot->direction);
  }
  return light;
}

}  // namespace

void complete_normals(PolygonModel& model, double smoothing_deg) {
  if (!has_normals(model)) average_normals(model, kAngleNormals, smoothing_deg);
}

void add_model_file(SceneFile& file, ModelFile&& models, const PlacedFile& placed) {
  Scene& scene = file.scene;
  const std::size_t first_mesh = scene.meshes.size();
  const auto first_material = static_cast<std::uint32_t>(scene.materials.size());
  for (PolygonModel& model : models.models) {
    for (PolygonFace& face : model.faces) face.material += first_material;
    scene.meshes.push_back(triangulated(model));
    model = {};
  }
  if (placed.material) {  // the file's own are not needed
    for (std::size_t i = first_mesh; i < scene.meshes.size(); ++i) {
      for (MeshTriangle& triangle : scene.meshes[i].triangles) triangle.material = 0;
    }
  } else {
    std::move(models.materials.begin(), models.materials.end(),
              std::back_inserter(scene.materials));
  }
  for (const PlacedModel& model : models.placed) {
    const std::string name = model.name.empty() || models.placed.size() == 1
                                 ? placed.name
                                 : placed.name + "." + model.name;
    scene.objects.push_back({name, first_mesh + model.model,
                             placed.world_from_file * model.world_from_model, placed.material});
  }
  if (placed.lights) {
    for (SceneLight& light : models.lights) {
      SceneLight moved = moved_light(std::move(light), placed.world_from_file);
      if (moved.name.empty() || find_by_name(scene.lights, moved.name) != nullptr) {
        moved.name = "light" + std::to_string(scene.lights.size() + 1);
      }
      scene.lights.push_back(std::move(moved));
    }
  }
  std::move(models.notes.begin(), models.notes.end(), std::back_inserter(file.notes));
}

void read_objects(const TomlTable& root, const SceneContext& context, SceneFile& file,
                  std::optional<Camera>& camera) {
  for (const TomlTable& table : root.tables("object")) read_object(table, context, file, camera);
}

}  // namespace tristim::detail
