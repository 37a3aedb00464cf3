#pragma once

#include <cstdint>
#include <vector>

#include "lib/render/triangle_planes.h"

namespace tristim::detail {

/// An edge between two triangles of a world, or at the border of one.
struct WorldEdge {
  std::uint32_t a = 0, b = 0;      // positions
  std::uint32_t face = 0;          // a triangle
  std::uint32_t other = kNoIndex;  // its neighbour, or none
};

/// Every edge once. Corners at the same place are one, so that seams of normals and of texture do
/// not count; where more than two triangles meet each further one has a border of its own.
std::vector<WorldEdge> edges_of(const World& world);

/// Adds the edges that `lines` asks for and that the camera sees, as flat stripes of its width
/// which are a little nearer than the surfaces beside them: outlines are borders and edges between
/// a front and a back face. Data of a stripe is that of a triangle beside it.
void add_edge_lines(const SeenWorld& seen, const std::vector<WorldEdge>& edges,
                    const EdgeLines& lines, std::uint32_t material,
                    std::vector<DeviceTriangle>& out);

}  // namespace tristim::detail
