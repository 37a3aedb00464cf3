#include <algorithm>
#include <limits>

#include "lib/core/trigonometry.h"
#include "lib/render/io/read_scene.h"
#include "tristim/light/vector.h"

namespace tristim::detail {
namespace {

using Eigen::Vector3d;

constexpr double kFar = std::numeric_limits<double>::max();

bool on_a_line(const Vector3d& a, const Vector3d& b) {
  return three_point_normal({0, 0, 0}, normalize(a), normalize(b)) == Vector3d(0, 0, 0);
}

}  // namespace

std::optional<Camera> read_camera(const TomlTable& root) {
  const auto table = root.table("camera");
  if (!table) return std::nullopt;
  Camera camera;
  camera.eye = read_vector(*table, "eye", camera.eye);
  camera.target = read_vector(*table, "target", camera.target);
  camera.up = read_direction(*table, "up", camera.up);
  if (camera.eye == camera.target) {
    table->fail("target", "the camera looks at its own place", "move eye or target");
  }
  if (on_a_line(camera.up, camera.target - camera.eye)) {
    table->fail("up", "up is the direction of the view",
                "give another direction, such as [0, 0, -1]");
  }
  camera.orthographic = table->boolean("orthographic").value_or(false);
  if (camera.orthographic) {
    camera.height = number_in(*table, "height", camera.height, kTiny, kFar, "above 0");
  } else {
    camera.fov_deg =
        number_in(*table, "fov_deg", camera.fov_deg, 0.001, 179.999, "above 0 and below 180");
  }
  camera.near =
      number_in(*table, "near", camera.near, std::numeric_limits<double>::min(), kFar, "above 0");
  if (table->has("far")) {
    camera.far = number_in(*table, "far", camera.far, camera.near, kFar, "above near");
    if (camera.far == camera.near) table->fail("far", "far is near", "give a larger number");
  }
  table->finish();
  return camera;
}

PictureSettings read_picture(const TomlTable& root) {
  PictureSettings picture;
  const auto table = root.table("picture");
  if (!table) return picture;
  if (const auto size = table->numbers("size")) {
    const bool good = size->size() == 2 && table->all_integers("size") &&
                      std::all_of(size->begin(), size->end(),
                                  [](double side) { return side >= 1 && side <= 65536; });
    if (!good)
      table->fail("size", "size is no size", "give [width, height], 1 to 65536 pixels each");
    picture.width = static_cast<int>((*size)[0]);
    picture.height = static_cast<int>((*size)[1]);
  }
  if (const auto samples = table->integer("samples")) {
    if (*samples != 1 && *samples != 4 && *samples != 16 && *samples != 64) {
      table->fail("samples", "samples = " + std::to_string(*samples) + " is not possible",
                  "give 1, 4, 16 or 64");
    }
    picture.samples = static_cast<int>(*samples);
  }
  picture.filter = choice(*table, "filter", kPixelFilters, picture.filter);
  picture.shading = choice(*table, "shading", kShadings, picture.shading);
  picture.affine = table->boolean("affine").value_or(picture.affine);
  table->finish();
  return picture;
}

EdgeLines read_edges(const TomlTable& root, const SceneContext& context) {
  EdgeLines edges;
  const auto table = root.table("edges");
  if (!table) return edges;
  edges.silhouettes = table->boolean("silhouettes").value_or(true);
  edges.creases = table->boolean("creases").value_or(true);
  edges.crease_deg = number_in(*table, "crease_deg", edges.crease_deg, 0, 180, "from 0 to 180");
  edges.width = number_in(*table, "width", edges.width, 0.01, 1000, "from 0.01 to 1000 pixels");
  edges.color = read_color(*table, "color", context, edges.color).rgb;
  table->finish();
  return edges;
}

Camera framing_camera(const Scene& scene) {
  Vector3d least(kFar, kFar, kFar);
  Vector3d most = -least;
  for (const SceneObject& object : scene.objects) {
    for (const Vector3d& p : scene.meshes[object.mesh].positions) {
      const Vector3d q = moved(object.world_from_object, p);
      least = least.cwiseMin(q);
      most = most.cwiseMax(q);
    }
  }
  Camera camera;
  if (!(least.x() <= most.x())) return camera;
  constexpr double kMargin = 1.05;
  camera.target = 0.5 * least + 0.5 * most;
  const double radius = std::max(length(most - camera.target), 1e-6);
  const double sine = sine_cosine_deg(camera.fov_deg / 2).sine;
  const double distance = kMargin * radius / sine;
  camera.eye = camera.target + distance * normalize(Vector3d(0.4, 0.3, 1));
  camera.near = std::max(distance - kMargin * radius, distance * 1e-3);
  return camera;
}

}  // namespace tristim::detail
