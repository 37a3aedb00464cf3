#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "tristim/render/render.h"

namespace tristim::detail {

/// A triangle of any object, with the numbers of what it has at its corners in World.
struct WorldTriangle {
  std::array<std::uint32_t, 3> position{};
  std::array<std::uint32_t, 3> normal{};  // kNoIndex: that of the face
  std::array<std::uint32_t, 3> uv{};      // kNoIndex: none
  std::uint32_t material = 0;
  std::uint32_t number = 0;  // from 1, counting those that were left out
};

/// All objects of a scene where they stand. Triangles without area are left out.
struct World {
  std::vector<Eigen::Vector3d> positions;
  std::vector<Eigen::Vector3d> normals;  // unit
  std::vector<Uv> uvs;
  std::vector<WorldTriangle> triangles;
};

/// Throws std::invalid_argument as SceneRenderer does. Counts in `report`.
World world_of(const Scene& scene, RenderReport& report);

/// The unit normal of a triangle, 0 where it has no area.
Eigen::Vector3d face_normal(const World& world, const WorldTriangle& triangle) noexcept;

}  // namespace tristim::detail
