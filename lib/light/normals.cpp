#include "tristim/light/normals.h"

#include <stdexcept>
#include <string>

#include "lib/light/angle.h"
#include "lib/light/corner.h"
#include "lib/light/precise.h"

namespace tristim {

namespace detail {

namespace {

PreciseVector newell(std::span<const Eigen::Vector3d> polygon) noexcept {
  PreciseVector sum;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const PreciseVector p = precise(polygon[k]);
    const PreciseVector q = precise(polygon[(k + 1) % polygon.size()]);
    sum = sum + PreciseVector{(p.y - q.y) * (p.z + q.z), (p.z - q.z) * (p.x + q.x),
                              (p.x - q.x) * (p.y + q.y)};
  }
  return sum;
}

}  // namespace

PreciseVector uniform_share(const Corner& corner) noexcept {
  return normalize(newell(corner.polygon));
}

PreciseVector area_share(const Corner& corner) noexcept {
  return DoubleDouble(0.5) * newell(corner.polygon);
}

PreciseVector angle_share(const Corner& corner) noexcept {
  const std::size_t count = corner.polygon.size();
  const PreciseVector here = precise(corner.polygon[corner.at]);
  const PreciseVector next = precise(corner.polygon[(corner.at + 1) % count]);
  const PreciseVector last = precise(corner.polygon[(corner.at + count - 1) % count]);
  return angle_between(next - here, last - here) * uniform_share(corner);
}

PreciseVector plane_share(const Corner& corner) noexcept { return precise(*corner.plane); }

}  // namespace detail

using detail::precise;
using Eigen::Vector3d;

namespace {

std::vector<Vector3d> polygon_of(const PolygonMesh& mesh, std::size_t face) {
  std::vector<Vector3d> polygon;
  for (const std::size_t vertex : mesh.faces[face]) {
    if (vertex >= mesh.vertices.size()) {
      throw std::invalid_argument("face " + std::to_string(face) + " names vertex " +
                                  std::to_string(vertex) + " of " +
                                  std::to_string(mesh.vertices.size()));
    }
    polygon.push_back(mesh.vertices[vertex]);
  }
  return polygon;
}

}  // namespace

Vector3d plane_normal(double a, double b, double c) noexcept {
  return rounded(normalize(precise(Vector3d(a, b, c))));
}

Vector3d three_point_normal(const Vector3d& p0, const Vector3d& p1, const Vector3d& p2) noexcept {
  const detail::PreciseVector from = precise(p0);
  return rounded(normalize(cross(precise(p1) - from, precise(p2) - from)));
}

Vector3d newell_normal(std::span<const Vector3d> polygon) noexcept {
  return rounded(detail::newell(polygon));
}

Vector3d unit_newell_normal(std::span<const Vector3d> polygon) noexcept {
  return rounded(normalize(detail::newell(polygon)));
}

double polygon_area(std::span<const Vector3d> polygon) noexcept {
  return (length(detail::newell(polygon)) / 2).hi;
}

Vector3d facing_normal(const Vector3d& normal, const Vector3d& to_eye) noexcept {
  return dot(precise(normal), precise(to_eye)).hi < 0 ? Vector3d(-normal) : normal;
}

std::vector<Vector3d> vertex_normals(const PolygonMesh& mesh, const NormalWeighting& weighting) {
  if (weighting.share == kPlaneNormals.share && mesh.planes.size() != mesh.faces.size()) {
    throw std::invalid_argument(std::to_string(mesh.planes.size()) + " planes for " +
                                std::to_string(mesh.faces.size()) + " faces");
  }
  std::vector<detail::PreciseVector> sums(mesh.vertices.size());
  for (std::size_t face = 0; face < mesh.faces.size(); ++face) {
    const std::vector<Vector3d> polygon = polygon_of(mesh, face);
    const Vector3d* plane = mesh.planes.empty() ? nullptr : &mesh.planes[face];
    for (std::size_t at = 0; at < polygon.size(); ++at) {
      detail::PreciseVector& sum = sums[mesh.faces[face][at]];
      sum = sum + weighting.share({polygon, at, plane});
    }
  }
  std::vector<Vector3d> normals;
  for (const detail::PreciseVector& sum : sums) normals.push_back(rounded(normalize(sum)));
  return normals;
}

}  // namespace tristim
