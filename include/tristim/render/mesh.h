#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <limits>
#include <vector>

namespace tristim {

/// A place in a texture.
struct Uv {
  float u = 0, v = 0;
  friend constexpr bool operator==(const Uv&, const Uv&) = default;
};

/// Stands for a normal or a texture coordinate that a corner does not have.
inline constexpr std::uint32_t kNoIndex = std::numeric_limits<std::uint32_t>::max();

/// The numbers of what a triangle has at a corner, from 0, in the arrays of its mesh.
struct MeshCorner {
  std::uint32_t position = 0;
  std::uint32_t normal = kNoIndex;  // kNoIndex: the normal of the face
  std::uint32_t uv = kNoIndex;      // kNoIndex: (0, 0)
  friend constexpr bool operator==(const MeshCorner&, const MeshCorner&) = default;
};

/// Corners counter-clockwise seen from outside.
struct MeshTriangle {
  std::array<MeshCorner, 3> corners{};
  std::uint32_t material = 0;  // of the scene's
  friend constexpr bool operator==(const MeshTriangle&, const MeshTriangle&) = default;
};

/// Triangles that share their corners. Triangles without area stay in it, so that the numbers of
/// the others are those of the file.
struct Mesh {
  std::vector<Eigen::Vector3d> positions = {};
  std::vector<Eigen::Vector3d> normals = {};  // of any length above 0
  std::vector<Uv> uvs = {};
  std::vector<MeshTriangle> triangles = {};
};

}  // namespace tristim
