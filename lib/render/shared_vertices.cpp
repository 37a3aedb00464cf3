#include "tristim/render/shared_vertices.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "tristim/light/vector.h"

namespace tristim {
namespace {

using Eigen::Vector3d;

// The vertices that faces name, by their x: an edge looks at those between its ends only.
std::vector<std::size_t> used_by_x(const PolygonMesh& mesh) {
  std::vector<std::size_t> used;
  for (std::size_t face = 0; face < mesh.faces.size(); ++face) {
    for (const std::size_t vertex : mesh.faces[face]) {
      if (vertex >= mesh.vertices.size()) {
        throw std::invalid_argument("face " + std::to_string(face) + " names vertex " +
                                    std::to_string(vertex) + " of " +
                                    std::to_string(mesh.vertices.size()));
      }
      used.push_back(vertex);
    }
  }
  const auto before = [&](std::size_t a, std::size_t b) {
    const double ax = mesh.vertices[a].x();
    const double bx = mesh.vertices[b].x();
    return ax != bx ? ax < bx : a < b;
  };
  std::sort(used.begin(), used.end(), before);
  used.erase(std::unique(used.begin(), used.end()), used.end());
  return used;
}

// Where a point lies on the edge from a to b, in (0, 1); 0 where it does not.
double place_on(const Vector3d& a, const Vector3d& b, const Vector3d& p, double tolerance) {
  const Vector3d along = b - a;
  const double squared = dot(along, along);
  if (!(squared > 0)) return 0;
  const double t = dot(p - a, along) / squared;
  const bool at_an_end = !(t > tolerance) || !(t < 1 - tolerance) || p == a || p == b;
  if (at_an_end) return 0;
  const Vector3d off = p - a - t * along;
  return length(off) <= tolerance * std::sqrt(squared) ? t : 0;
}

bool names(const std::vector<std::size_t>& face, std::size_t vertex) {
  return std::find(face.begin(), face.end(), vertex) != face.end();
}

}  // namespace

std::vector<TJunction> t_junctions(const PolygonMesh& mesh, double tolerance) {
  const std::vector<std::size_t> used = used_by_x(mesh);
  std::vector<TJunction> found;
  for (std::size_t face = 0; face < mesh.faces.size(); ++face) {
    const std::vector<std::size_t>& corners = mesh.faces[face];
    for (std::size_t edge = 0; edge < corners.size(); ++edge) {
      const Vector3d& a = mesh.vertices[corners[edge]];
      const Vector3d& b = mesh.vertices[corners[(edge + 1) % corners.size()]];
      const double reach = tolerance * length(b - a);
      const auto first = std::partition_point(used.begin(), used.end(), [&](std::size_t v) {
        return mesh.vertices[v].x() < std::min(a.x(), b.x()) - reach;
      });
      std::vector<TJunction> on_edge;
      for (auto v = first; v != used.end(); ++v) {
        if (mesh.vertices[*v].x() > std::max(a.x(), b.x()) + reach) break;
        const double t = place_on(a, b, mesh.vertices[*v], tolerance);
        if (t > 0 && !names(corners, *v)) on_edge.push_back({*v, face, edge, t});
      }
      std::sort(on_edge.begin(), on_edge.end(),
                [](const TJunction& p, const TJunction& q) { return p.vertex < q.vertex; });
      found.insert(found.end(), on_edge.begin(), on_edge.end());
    }
  }
  return found;
}

double intensity_gap(const PolygonMesh& mesh, const TJunction& junction,
                     std::span<const double> intensities) {
  const std::vector<std::size_t>& corners = mesh.faces[junction.face];
  const double a = intensities[corners[junction.edge]];
  const double b = intensities[corners[(junction.edge + 1) % corners.size()]];
  return std::fabs(intensities[junction.vertex] - ((1 - junction.t) * a + junction.t * b));
}

}  // namespace tristim
