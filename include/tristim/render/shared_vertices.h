#pragma once

#include <span>
#include <vector>

#include "tristim/light/normals.h"

namespace tristim {

/// A vertex of one face in the middle of an edge of another that does not have it [Shoaff 4.3]. The
/// two are shaded by different intensities there: a crack in the shading, and in the picture where
/// the vertex is not quite on the edge.
struct TJunction {
  std::size_t vertex = 0;
  std::size_t face = 0;  // whose edge it is
  std::size_t edge = 0;  // from its vertex of that position to the next
  double t = 0;          // how far along, in (0, 1)
};

/// Every such place of a mesh: vertices of faces within `tolerance` (a part of the edge's length,
/// 0 or more) of an edge, and not at its ends. Vertices in one place are one. In order of faces,
/// edges and vertices. Throws std::invalid_argument where a face names no vertex.
std::vector<TJunction> t_junctions(const PolygonMesh& mesh, double tolerance = 1e-9);

/// By how much the intensities of the two faces differ there, |I_V - (1 - t) I_A - t I_B|;
/// `intensities` has one for each vertex of the mesh.
double intensity_gap(const PolygonMesh& mesh, const TJunction& junction,
                     std::span<const double> intensities);

}  // namespace tristim
