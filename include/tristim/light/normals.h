#pragma once

#include <Eigen/Core>
#include <array>
#include <span>
#include <string_view>
#include <vector>

namespace tristim {

/// The unit normal of the plane a x + b y + c z + d = 0: (a, b, c) / |(a, b, c)| [Shoaff 3.5]; 0
/// where all are 0. Rounded once.
Eigen::Vector3d plane_normal(double a, double b, double c) noexcept;

/// The unit normal of three points, counter-clockwise seen from outside:
/// (p1 - p0) x (p2 - p0) [Shoaff 3.5]; 0 where they lie on a line. Rounded once.
Eigen::Vector3d three_point_normal(const Eigen::Vector3d& p0, const Eigen::Vector3d& p1,
                                   const Eigen::Vector3d& p2) noexcept;

/// The sums (y_k - y_k+1)(z_k + z_k+1), (z_k - z_k+1)(x_k + x_k+1), (x_k - x_k+1)(y_k + y_k+1)
/// round the polygon, Newell's normal [Shoaff 3.5]: twice the area long, counter-clockwise seen
/// from outside. Right for polygons that are not quite flat and where the first three vertices lie
/// on a line. 0 for fewer than three vertices. Rounded once.
Eigen::Vector3d newell_normal(std::span<const Eigen::Vector3d> polygon) noexcept;

/// newell_normal as a unit vector; 0 where the area is. Rounded once.
Eigen::Vector3d unit_newell_normal(std::span<const Eigen::Vector3d> polygon) noexcept;

/// Half the length of newell_normal: the area of a flat polygon. Rounded once.
double polygon_area(std::span<const Eigen::Vector3d> polygon) noexcept;

/// The normal on the eye's side, for surfaces with two sides [Shoaff 3.5]: N or, where N.V is below
/// 0, -N.
Eigen::Vector3d facing_normal(const Eigen::Vector3d& normal,
                              const Eigen::Vector3d& to_eye) noexcept;

namespace detail {
struct PreciseVector;
struct Corner;
PreciseVector uniform_share(const Corner& corner) noexcept;
PreciseVector area_share(const Corner& corner) noexcept;
PreciseVector angle_share(const Corner& corner) noexcept;
PreciseVector plane_share(const Corner& corner) noexcept;
}  // namespace detail

/// What a face adds to the normal at one of its vertices; the sum is made a unit vector.
struct NormalWeighting {
  std::string_view name;
  std::string_view formula;
  std::string_view source;
  detail::PreciseVector (*share)(const detail::Corner& corner) noexcept;
};

inline constexpr NormalWeighting kUniformNormals{"uniform", "sum of the faces' unit normals",
                                                 "[Gouraud71]", detail::uniform_share};
inline constexpr NormalWeighting kAreaNormals{"area", "sum of the Newell normals / 2",
                                              "[Shoaff 4.3]", detail::area_share};
inline constexpr NormalWeighting kAngleNormals{
    "angle", "sum of the unit normals times the angles at the vertex", "[Thuermer98]",
    detail::angle_share};
/// "Adding the normals" with plane coefficients of any length, as the truncated pyramid of
/// [Shoaff 4.3] is done; their lengths weigh.
inline constexpr NormalWeighting kPlaneNormals{"plane", "sum of the plane coefficients as given",
                                               "[Shoaff 4.3]", detail::plane_share};

/// Every weighting. The command line, the docs and the tests read this list.
inline constexpr std::array kNormalWeightings{kPlaneNormals, kUniformNormals, kAreaNormals,
                                              kAngleNormals};

/// A polygon mesh: faces are the numbers of their vertices, counter-clockwise seen from outside.
struct PolygonMesh {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<std::vector<std::size_t>> faces;
  std::vector<Eigen::Vector3d> planes;  // (a, b, c) of each face, or none
};

/// The unit normal at each vertex; 0 where its faces cancel or it has none. Rounded once.
/// Throws std::invalid_argument where a face names no vertex, or kPlaneNormals finds no plane.
std::vector<Eigen::Vector3d> vertex_normals(const PolygonMesh& mesh,
                                            const NormalWeighting& weighting);

}  // namespace tristim
