#include "lib/render/triangle_planes.h"

#include "lib/render/cross.h"
#include "tristim/light/vector.h"

namespace tristim::detail {
namespace {

using Eigen::Vector3d;

using Corners = std::array<DevicePoint, 3>;

Corners device_corners(const SeenWorld& seen, const WorldTriangle& triangle) {
  return {seen.vertices[triangle.position[0]].point, seen.vertices[triangle.position[1]].point,
          seen.vertices[triangle.position[2]].point};
}

// As if all corners were equally far away.
void flatten(Corners& corners) noexcept {
  for (const DevicePoint& p : corners) {
    if (!(p.w > 0)) return;
  }
  for (DevicePoint& p : corners) p = {p.x / p.w, p.y / p.w, 1, p.distance};
}

// The rows of the inverse of the matrix whose columns are the corners (x, y, w).
CornerWeights weights_of(const FixedGrid& grid, const Corners& corners, const FixedPoint& origin) {
  const double pixel = 1.0 / static_cast<double>(std::int64_t{1} << grid.bits);
  CornerWeights weights;
  weights.x0 = origin.x * pixel;
  weights.y0 = origin.y * pixel;
  std::array<Vector3d, 3> columns;
  for (std::size_t i = 0; i < 3; ++i) {
    const DevicePoint& p = corners[i];
    columns[i] = Vector3d(p.x - weights.x0 * p.w, p.y - weights.y0 * p.w, p.w);
  }
  const Vector3d first = cross(columns[1], columns[2]);
  const double inverse = 1 / dot(first, columns[0]);
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector3d row = inverse * cross(columns[(i + 1) % 3], columns[(i + 2) % 3]);
    weights.corners[i] = {row.z(), row.x(), row.y()};
  }
  return weights;
}

Plane plane_of_normal(const CornerWeights& weights, const std::array<Vector3d, 3>& normals,
                      int axis) noexcept {
  return weights.of(normals[0][axis], normals[1][axis], normals[2][axis]);
}

Plane sum(const Plane& a, const Plane& b) noexcept {
  return {a.start + b.start, a.dx + b.dx, a.dy + b.dy};
}

}  // namespace

CornerWeights corner_weights(const SeenWorld& seen, const DeviceTriangle& drawn, bool affine) {
  Corners corners = device_corners(seen, seen.world.triangles[drawn.triangle]);
  if (affine) flatten(corners);
  return weights_of(seen.grid, corners, drawn.at[0]);
}

std::array<Vector3d, 3> corner_normals(const World& world, const WorldTriangle& triangle) {
  std::array<Vector3d, 3> normals;
  const auto& [a, b, c] = triangle.normal;
  const bool needs_face = a == kNoIndex || b == kNoIndex || c == kNoIndex;
  const Vector3d face = needs_face ? face_normal(world, triangle) : Vector3d::Zero();
  for (std::size_t i = 0; i < 3; ++i) {
    normals[i] = triangle.normal[i] == kNoIndex ? face : world.normals[triangle.normal[i]];
  }
  return normals;
}

SurfacePlanes surface_planes(const SeenWorld& seen, const DeviceTriangle& drawn, bool affine) {
  const WorldTriangle& triangle = seen.world.triangles[drawn.triangle];
  const Corners corners = device_corners(seen, triangle);
  CornerWeights weights = weights_of(seen.grid, corners, drawn.at[0]);
  SurfacePlanes planes;
  planes.x0 = weights.x0;
  planes.y0 = weights.y0;
  planes.set(SurfacePlanes::kNearness,
             seen.view.orthographic
                 ? weights.of(corners[0].distance, corners[1].distance, corners[2].distance)
                 : sum(sum(weights.corners[0], weights.corners[1]), weights.corners[2]));
  if (affine) weights = corner_weights(seen, drawn, true);
  const std::array<Vector3d, 3> normals = corner_normals(seen.world, triangle);
  planes.set(SurfacePlanes::kX, plane_of_normal(weights, normals, 0));
  planes.set(SurfacePlanes::kY, plane_of_normal(weights, normals, 1));
  planes.set(SurfacePlanes::kZ, plane_of_normal(weights, normals, 2));
  return planes;
}

}  // namespace tristim::detail
