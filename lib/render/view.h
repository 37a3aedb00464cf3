#pragma once

#include <Eigen/Core>

#include "tristim/light/source.h"
#include "tristim/render/scene.h"

namespace tristim::detail {

/// A camera in front of a raster of pixels, y down. Device coordinates are to_viewport's.
struct View {
  int width = 0, height = 0;
  Eigen::Vector3d eye;
  Eigen::Vector3d right, up, back;  // unit; back is from the target to the eye
  bool orthographic = false;
  double scale = 1;  // pixels for a length of 1 at w = 1
  double near = 0, far = 0;
};

/// Throws std::invalid_argument for a camera or a size out of range.
View view_of(const Camera& camera, int width, int height);

/// For lights that are fixed to the camera.
CameraPose pose_of(const View& view) noexcept;

/// A point in device coordinates times w: w is the distance along the view axis, 1 where the camera
/// is orthographic.
struct DevicePoint {
  double x = 0, y = 0, w = 1;
  double distance = 0;  // along the view axis
};

DevicePoint to_device(const View& view, const Eigen::Vector3d& world) noexcept;

/// Where a pixel looks: the points from + distance * along have that distance along the view axis;
/// relative to the eye.
struct ViewRay {
  Eigen::Vector3d from, along;
};

ViewRay view_ray(const View& view, double x, double y) noexcept;

}  // namespace tristim::detail
