#pragma once

#include <Eigen/Core>
#include <array>

#include "lib/render/device_triangles.h"

namespace tristim::detail {

/// A value that is linear in the picture: start + dx (x - x0) + dy (y - y0), in pixels.
struct Plane {
  double start = 0, dx = 0, dy = 0;

  double at(double across, double down) const noexcept { return start + (dx * across + dy * down); }
};

/// The parts that a triangle's corners have in the point that a pixel sees, over w: their sum is
/// 1/w (1 where the camera is orthographic) [Olano97]. So a value of the corners, weighted with
/// them, over that sum is interpolated rightly in perspective.
struct CornerWeights {
  double x0 = 0, y0 = 0;  // pixels; the planes start there
  std::array<Plane, 3> corners{};

  /// The plane of a value that the corners have.
  Plane of(double a, double b, double c) const noexcept {
    const auto& [pa, pb, pc] = corners;
    return {a * pa.start + b * pb.start + c * pc.start, a * pa.dx + b * pb.dx + c * pc.dx,
            a * pa.dy + b * pb.dy + c * pc.dy};
  }
};

/// A camera and what it sees of the corners of a world.
struct SeenWorld {
  const World& world;
  View view;
  FixedGrid grid;
  std::vector<DeviceVertex> vertices;
};

/// Of the whole triangle, whichever piece `drawn` is of it; the planes start at the piece's first
/// corner. `affine`: linear in the picture, except where the triangle reaches behind the eye.
CornerWeights corner_weights(const SeenWorld& seen, const DeviceTriangle& drawn, bool affine);

/// The normals at the corners.
std::array<Eigen::Vector3d, 3> corner_normals(const World& world, const WorldTriangle& triangle);

/// What shading needs of a triangle at each sample: four planes that start at (x0, y0), of 1/w
/// (where orthographic of the distance along the view axis) and of the normal, of any length.
struct SurfacePlanes {
  static constexpr std::size_t kNearness = 0, kX = 1, kY = 2, kZ = 3;
  double x0 = 0, y0 = 0;
  std::array<double, 4> start{}, dx{}, dy{};
  std::array<float, 4> step{};  // dx

  void set(std::size_t k, const Plane& plane) noexcept {
    start[k] = plane.start;
    dx[k] = plane.dx;
    dy[k] = plane.dy;
    step[k] = static_cast<float>(plane.dx);
  }
};

SurfacePlanes surface_planes(const SeenWorld& seen, const DeviceTriangle& drawn, bool affine);

}  // namespace tristim::detail
