#include "lib/render/view.h"

#include <cmath>
#include <stdexcept>
#include <string>

#include "lib/core/trigonometry.h"
#include "lib/render/cross.h"
#include "tristim/core/text.h"
#include "tristim/light/vector.h"

namespace tristim::detail {
namespace {

using Eigen::Vector3d;

void check(const char* what, double value, bool good, const char* expected) {
  if (good) return;
  throw std::invalid_argument(std::string("camera: ") + what + ": " + shortest(value) +
                              "; expected " + expected);
}

void check_lens(const Camera& camera) {
  check("near", camera.near, camera.near > 0 && std::isfinite(camera.near), "above 0");
  check("far", camera.far, camera.far > camera.near, "above near");
  if (camera.orthographic) {
    check("height", camera.height, camera.height > 0 && std::isfinite(camera.height), "above 0");
  } else {
    check("fov_deg", camera.fov_deg, camera.fov_deg > 0 && camera.fov_deg < 180,
          "above 0, below 180");
  }
}

void check_size(int side) {
  constexpr int kMostSide = 65536;
  if (side >= 1 && side <= kMostSide) return;
  throw std::invalid_argument("size of the picture: " + std::to_string(side) +
                              "; expected 1 to 65536 a side");
}

// Pixels for a length of 1 at distance 1, or at any distance.
double scale_of(const Camera& camera, int height) {
  if (camera.orthographic) return height / camera.height;
  const SineCosine half = sine_cosine_deg(camera.fov_deg / 2);
  return height * half.cosine / (2 * half.sine);
}

}  // namespace

View view_of(const Camera& camera, int width, int height) {
  check_lens(camera);
  check_size(width);
  check_size(height);
  View view;
  view.width = width;
  view.height = height;
  view.eye = camera.eye;
  view.back = normalize(camera.eye - camera.target);
  view.right = normalize(cross(camera.up, view.back));
  view.up = cross(view.back, view.right);
  view.orthographic = camera.orthographic;
  view.scale = scale_of(camera, height);
  view.near = camera.near;
  view.far = camera.far;
  const bool placed = camera.eye.allFinite() && view.back.allFinite() && view.right.allFinite();
  if (!placed || dot(view.right, view.right) == 0) {
    throw std::invalid_argument(
        "camera: eye, target and up give no direction; expected finite places, apart, with up "
        "across the view");
  }
  return view;
}

CameraPose pose_of(const View& view) noexcept {
  CameraPose pose;
  pose.world_from_camera.col(0) = view.right;
  pose.world_from_camera.col(1) = view.up;
  pose.world_from_camera.col(2) = view.back;
  pose.eye = view.eye;
  return pose;
}

DevicePoint to_device(const View& view, const Vector3d& world) noexcept {
  const Vector3d seen = world - view.eye;
  DevicePoint point;
  point.distance = -dot(seen, view.back);
  point.w = view.orthographic ? 1 : point.distance;
  point.x = view.scale * dot(seen, view.right) + view.width / 2.0 * point.w;
  point.y = view.height / 2.0 * point.w - view.scale * dot(seen, view.up);
  return point;
}

ViewRay view_ray(const View& view, double x, double y) noexcept {
  const Vector3d across = (x - view.width / 2.0) / view.scale * view.right +
                          (view.height / 2.0 - y) / view.scale * view.up;
  if (view.orthographic) return {across, -view.back};
  return {Vector3d::Zero(), across - view.back};
}

}  // namespace tristim::detail
