#include "tristim/render/polygon_model.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <array>
#include <cmath>

namespace tristim {
namespace {

using Eigen::Vector3d;

PolygonModel one_polygon(std::vector<Vector3d> points) {
  PolygonModel model{.positions = std::move(points)};
  std::vector<MeshCorner> corners;
  for (std::uint32_t i = 0; i < model.positions.size(); ++i) corners.push_back({i});
  add_face(model, corners, 7);
  return model;
}

// The areas of its triangles along the normal: a triangle that lies wrong takes away.
double area_along(const Mesh& mesh, const Vector3d& normal) {
  double sum = 0;
  for (const MeshTriangle& triangle : mesh.triangles) {
    const auto at = [&](std::size_t i) { return mesh.positions[triangle.corners[i].position]; };
    const double area = (at(1) - at(0)).cross(at(2) - at(0)).dot(normal) / 2;
    EXPECT_GE(area, 0);
    sum += area;
  }
  return sum;
}

TEST(Triangulated, ConvexPolygonsAreFans) {
  const Mesh mesh = triangulated(one_polygon({{0, 0, 0}, {2, 0, 0}, {3, 1, 0}, {1, 3, 0}}));
  ASSERT_EQ(mesh.triangles.size(), 2U);
  EXPECT_EQ(mesh.triangles[1].corners[0].position, 0U);
  EXPECT_EQ(mesh.triangles[1].corners[1].position, 2U);
  EXPECT_EQ(mesh.triangles[1].corners[2].position, 3U);
  EXPECT_EQ(mesh.triangles[1].material, 7U);
}

TEST(Triangulated, EarsAreCutWhereAFanWouldLeaveThePolygon) {
  // An arrow whose first corner does not see its third, in each of the planes and from both sides.
  const std::vector<Vector3d> arrow{{2, 2, 0}, {0, 1, 0}, {1, 1, 0}, {1, 0, 0}};
  for (int axis = 0; axis < 3; ++axis) {
    for (const bool from_behind : {false, true}) {
      std::vector<Vector3d> turned;
      for (const Vector3d& p : arrow) {
        Vector3d q;
        q[axis] = 5;
        q[(axis + 1) % 3] = p.x();
        q[(axis + 2) % 3] = p.y();
        turned.push_back(q);
      }
      if (from_behind) std::reverse(turned.begin(), turned.end());
      const PolygonModel model = one_polygon(turned);
      const Vector3d normal = unit_newell_normal(model.positions);
      EXPECT_NEAR(area_along(triangulated(model), normal), polygon_area(model.positions), 1e-15);
    }
  }
}

TEST(Triangulated, CombsStarsAndPointsOnEdges) {
  std::vector<Vector3d> star;
  for (int i = 0; i < 30; ++i) {
    const double r = i % 2 == 0 ? 1 : 0.3;
    const double angle = i * 3.14159265358979 / 15;
    star.emplace_back(r * std::cos(angle), r * std::sin(angle), 0.5 * r * std::cos(angle));
  }
  const std::vector<Vector3d> comb{{0, 0, 0}, {4, 0, 0}, {4, 3, 0}, {3, 3, 0}, {3, 1, 0},
                                   {2, 1, 0}, {2, 3, 0}, {1, 3, 0}, {1, 1, 0}, {0, 1, 0}};
  const std::vector<Vector3d> midpoints{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0},
                                        {2, 2, 0}, {1, 2, 0}, {0, 2, 0}, {0, 1, 0}};
  for (const auto& points : {star, comb, midpoints}) {
    const PolygonModel model = one_polygon(points);
    const Mesh mesh = triangulated(model);
    EXPECT_EQ(mesh.triangles.size(), points.size() - 2);
    EXPECT_NEAR(area_along(mesh, unit_newell_normal(points)), polygon_area(points), 1e-13);
    EXPECT_EQ(degenerate_count(mesh), 0U);
  }
}

TEST(Triangulated, AnyPolygonEndsAndKeepsItsNumber) {
  const std::vector<Vector3d> bow_tie{{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}, {0.5, 2, 0}};
  EXPECT_EQ(triangulated(one_polygon(bow_tie)).triangles.size(), 3U);
  const std::vector<Vector3d> same(6, Vector3d(1, 2, 3));
  const Mesh nothing = triangulated(one_polygon(same));
  EXPECT_EQ(nothing.triangles.size(), 4U);
  EXPECT_EQ(degenerate_count(nothing), 4U);
  EXPECT_TRUE(triangulated(one_polygon({{0, 0, 0}, {1, 0, 0}})).triangles.empty());
}

TEST(PolygonModelOf, AMeshAndBack) {
  const Mesh mesh = triangulated(one_polygon({{0, 0, 0}, {2, 0, 0}, {3, 1, 0}, {1, 3, 0}}));
  const Mesh again = triangulated(polygon_model(mesh));
  EXPECT_EQ(again.positions, mesh.positions);
  EXPECT_EQ(again.triangles, mesh.triangles);
}

}  // namespace
}  // namespace tristim
