#include "tristim/render/polygon_model.h"

#include <algorithm>
#include <array>

#include "tristim/light/vector.h"

namespace tristim {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

// A polygon laid flat: seen along its normal it runs counter-clockwise.
std::vector<Vector2d> flattened(std::span<const Vector3d> polygon, const Vector3d& normal) {
  Eigen::Index away = 0;  // the axis that the polygon faces most
  (void)normal.cwiseAbs().maxCoeff(&away);
  const Eigen::Index u = (away + 1) % 3;
  const Eigen::Index v = (away + 2) % 3;
  const bool turned = normal[away] < 0;
  std::vector<Vector2d> flat;
  for (const Vector3d& p : polygon) flat.emplace_back(turned ? p[v] : p[u], turned ? p[u] : p[v]);
  return flat;
}

double turn(const Vector2d& a, const Vector2d& b, const Vector2d& c) noexcept {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

bool is_convex(std::span<const Vector2d> polygon) noexcept {
  const std::size_t count = polygon.size();
  for (std::size_t i = 0; i < count; ++i) {
    if (!(turn(polygon[i], polygon[(i + 1) % count], polygon[(i + 2) % count]) > 0)) return false;
  }
  return true;
}

// The corners of a polygon that are left while ears are cut off, as a ring.
class EarCutter {
 public:
  explicit EarCutter(std::span<const Vector2d> polygon) : polygon_(polygon) {
    for (std::size_t i = 0; i < polygon.size(); ++i) left_.push_back(i);
  }

  // Each triangle by the polygon's corners. Where no ear is found, which only polygons do that meet
  // themselves, any corner is taken: their number stays the same.
  std::vector<std::array<std::size_t, 3>> cut() {
    std::vector<std::array<std::size_t, 3>> triangles;
    std::size_t at = 0;
    std::size_t tried = 0;
    while (left_.size() > 3) {
      if (!is_ear(at) && tried < left_.size()) {
        at = next(at);
        ++tried;
        continue;
      }
      triangles.push_back({left_[last(at)], left_[at], left_[next(at)]});
      left_.erase(left_.begin() + static_cast<std::ptrdiff_t>(at));
      at %= left_.size();
      tried = 0;
    }
    triangles.push_back({left_[0], left_[1], left_[2]});
    return triangles;
  }

 private:
  std::size_t next(std::size_t i) const { return (i + 1) % left_.size(); }
  std::size_t last(std::size_t i) const { return (i + left_.size() - 1) % left_.size(); }
  const Vector2d& at(std::size_t i) const { return polygon_[left_[i]]; }

  // A corner that turns left with none of the others in its triangle.
  bool is_ear(std::size_t i) const {
    const Vector2d& a = at(last(i));
    const Vector2d& b = at(i);
    const Vector2d& c = at(next(i));
    if (!(turn(a, b, c) > 0)) return false;
    for (const std::size_t corner : left_) {
      const Vector2d& p = polygon_[corner];
      if (p == a || p == b || p == c) continue;
      if (turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0) return false;
    }
    return true;
  }

  std::span<const Vector2d> polygon_;
  std::vector<std::size_t> left_;
};

std::vector<std::array<std::size_t, 3>> triangles_of(std::span<const Vector3d> polygon) {
  if (polygon.size() == 3) return {{0, 1, 2}};
  const std::vector<Vector2d> flat = flattened(polygon, newell_normal(polygon));
  if (!is_convex(flat)) return EarCutter(flat).cut();
  std::vector<std::array<std::size_t, 3>> fan;
  for (std::size_t i = 2; i < polygon.size(); ++i) fan.push_back({0, i - 1, i});
  return fan;
}

}  // namespace

void add_face(PolygonModel& model, std::span<const MeshCorner> corners, std::uint32_t material) {
  model.faces.push_back({model.corners.size(), corners.size(), material});
  model.corners.insert(model.corners.end(), corners.begin(), corners.end());
}

PolygonModel polygon_model(const Mesh& mesh) {
  PolygonModel model{.positions = mesh.positions, .normals = mesh.normals, .uvs = mesh.uvs};
  model.corners.reserve(3 * mesh.triangles.size());
  model.faces.reserve(mesh.triangles.size());
  for (const MeshTriangle& triangle : mesh.triangles) {
    add_face(model, triangle.corners, triangle.material);
  }
  return model;
}

Mesh triangulated(const PolygonModel& model) {
  Mesh mesh{.positions = model.positions, .normals = model.normals, .uvs = model.uvs};
  mesh.triangles.reserve(model.faces.size());
  std::vector<Vector3d> polygon;
  for (const PolygonFace& face : model.faces) {
    if (face.count < 3) continue;
    const std::span<const MeshCorner> corners = model.corners_of(face);
    polygon.clear();
    for (const MeshCorner& corner : corners) polygon.push_back(model.positions[corner.position]);
    for (const auto& [a, b, c] : triangles_of(polygon)) {
      mesh.triangles.push_back({{corners[a], corners[b], corners[c]}, face.material});
    }
  }
  return mesh;
}

std::size_t degenerate_count(const Mesh& mesh) noexcept {
  const auto without_area = [&](const MeshTriangle& triangle) {
    const Vector3d& a = mesh.positions[triangle.corners[0].position];
    const Vector3d& b = mesh.positions[triangle.corners[1].position];
    const Vector3d& c = mesh.positions[triangle.corners[2].position];
    return three_point_normal(a, b, c) == Vector3d(0, 0, 0);
  };
  return static_cast<std::size_t>(
      std::count_if(mesh.triangles.begin(), mesh.triangles.end(), without_area));
}

}  // namespace tristim
