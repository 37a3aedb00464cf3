#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "lib/render/view.h"
#include "lib/render/world.h"

namespace tristim::detail {

/// A place in the picture in whole steps of 2^-bits of a pixel.
struct FixedPoint {
  std::int32_t x = 0, y = 0;
};

/// What is drawn of a triangle of the world: itself, or a piece of it that clipping left. Corners
/// run so that its inside is where all edge functions are above 0; it has an area.
struct DeviceTriangle {
  std::array<FixedPoint, 3> at{};
  std::array<double, 3> nearness{};  // at the corners: 1/w, -distance where orthographic
  std::uint32_t triangle = 0;        // of the world
  std::uint32_t material = 0;        // of the scene
  bool back = false;                 // seen from behind
};

/// The fixed-point grid of a picture. Places within `guard` pixels of the picture leave edge
/// functions in 64 bits.
struct FixedGrid {
  int bits = 16;
  double guard = 0;
  bool centres_only = false;  // the only samples are the pixels' centres
};

FixedGrid fixed_grid(int width, int height, int samples = 1) noexcept;

/// Twice the area in steps squared, above 0 where the corners run counter-clockwise for somebody
/// who sees y upwards.
inline std::int64_t twice_area(const FixedPoint& a, const FixedPoint& b,
                               const FixedPoint& c) noexcept {
  const auto apart = [](std::int32_t p, std::int32_t q) { return std::int64_t{p} - q; };
  return apart(c.x, a.x) * apart(b.y, a.y) - apart(b.x, a.x) * apart(c.y, a.y);
}

/// What is nearer is larger: 1/w, -distance where the camera is orthographic.
inline double nearness_of(const View& view, const DevicePoint& p) noexcept {
  return view.orthographic ? -p.distance : 1 / p.w;
}

/// A corner of the world in the picture.
struct DeviceVertex {
  DevicePoint point;
  FixedPoint at;
  std::uint32_t outside = 0;  // a bit for each plane that it is behind
};

DeviceVertex device_vertex(const View& view, const FixedGrid& grid,
                           const Eigen::Vector3d& world) noexcept;

/// What is seen of the triangles first..last - 1, in their order: nothing of what lies outside, of
/// back faces whose material has one side, of triangles that have no area in the picture, or of
/// those between two rows or columns of samples.
void add_device_triangles(const View& view, const FixedGrid& grid, const World& world,
                          std::span<const DeviceVertex> vertices,
                          std::span<const SceneMaterial> materials, std::uint32_t first,
                          std::uint32_t last, std::vector<DeviceTriangle>& out);

}  // namespace tristim::detail
