#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "tristim/light/normals.h"
#include "tristim/render/mesh.h"

namespace tristim {

/// A polygon of a model: its corners are `count` of the model's, from `first` on, counter-clockwise
/// seen from outside.
struct PolygonFace {
  std::size_t first = 0;
  std::size_t count = 0;
  std::uint32_t material = 0;
};

/// What files and shapes are made of, before it becomes triangles: polygons of any number of
/// corners. All numbers of corners are good.
struct PolygonModel {
  std::vector<Eigen::Vector3d> positions = {};
  std::vector<Eigen::Vector3d> normals = {};
  std::vector<Uv> uvs = {};
  std::vector<MeshCorner> corners = {};
  std::vector<PolygonFace> faces = {};
  std::vector<Eigen::Vector3d> planes = {};  // (a, b, c) of each face, or none

  std::span<const MeshCorner> corners_of(const PolygonFace& face) const noexcept {
    return std::span(corners).subspan(face.first, face.count);
  }
};

/// Adds a face.
void add_face(PolygonModel& model, std::span<const MeshCorner> corners, std::uint32_t material = 0);

/// A mesh as a model of triangles.
PolygonModel polygon_model(const Mesh& mesh);

/// The mesh of a model: a polygon of n corners becomes n - 2 triangles, in the order of the faces.
/// Convex polygons are fans about their first corner; of the others ears are cut off, in the plane
/// of their Newell normal [Meisters75], so that what is outside of them stays so. A polygon that
/// meets itself becomes n - 2 triangles of some kind; faces of less than three corners none.
Mesh triangulated(const PolygonModel& model);

/// How many triangles of a mesh have no area: two corners are in one place, or all three on a line.
std::size_t degenerate_count(const Mesh& mesh) noexcept;

}  // namespace tristim
