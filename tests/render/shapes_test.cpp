#include "tristim/render/shapes.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "tristim/core/find.h"
#include "tristim/light/normals.h"

namespace tristim {
namespace {

using Eigen::Vector3d;

PolygonModel shape_of(std::string_view name) { return make_shape(*find_by_name(shapes(), name)); }

PolygonModel shape_of(std::string_view name, std::vector<double> values) {
  return find_by_name(shapes(), name)->make(values);
}

std::vector<Vector3d> polygon_of(const PolygonModel& model, const PolygonFace& face) {
  std::vector<Vector3d> polygon;
  for (const MeshCorner& corner : model.corners_of(face)) {
    polygon.push_back(model.positions[corner.position]);
  }
  return polygon;
}

double volume(const Mesh& mesh) {
  double sum = 0;
  for (const MeshTriangle& triangle : mesh.triangles) {
    const auto at = [&](std::size_t i) { return mesh.positions[triangle.corners[i].position]; };
    sum += at(0).dot(at(1).cross(at(2))) / 6;
  }
  return sum;
}

// How often each edge is run along in each direction.
std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges_of(const PolygonModel& model) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  for (const PolygonFace& face : model.faces) {
    const auto corners = model.corners_of(face);
    for (std::size_t i = 0; i < corners.size(); ++i) {
      ++edges[{corners[i].position, corners[(i + 1) % corners.size()].position}];
    }
  }
  return edges;
}

TEST(Shapes, NumbersAreGoodAndNormalsPointOutwards) {
  for (const Shape& shape : shapes()) {
    SCOPED_TRACE(shape.name);
    const PolygonModel model = make_shape(shape);
    EXPECT_EQ(degenerate_count(triangulated(model)), 0U);
    for (const PolygonFace& face : model.faces) {
      const Vector3d out = newell_normal(polygon_of(model, face));
      for (const MeshCorner& corner : model.corners_of(face)) {
        ASSERT_LT(corner.position, model.positions.size());
        if (corner.uv != kNoIndex) ASSERT_LT(corner.uv, model.uvs.size());
        if (corner.normal == kNoIndex) continue;
        ASSERT_LT(corner.normal, model.normals.size());
        EXPECT_GT(model.normals[corner.normal].dot(out), 0);
      }
    }
  }
}

TEST(Shapes, ClosedOnesAreWatertight) {
  for (const char* name :
       {"sphere", "icosphere", "cylinder", "cone", "paraboloid", "torus", "box", "pyramid"}) {
    SCOPED_TRACE(name);
    const PolygonModel model = shape_of(name);
    const auto edges = edges_of(model);
    for (const auto& [edge, count] : edges) {
      EXPECT_EQ(count, 1);
      EXPECT_EQ(edges.count({edge.second, edge.first}), 1U);
    }
    std::set<std::tuple<double, double, double>> places;
    for (const Vector3d& p : model.positions) places.insert({p.x(), p.y(), p.z()});
    EXPECT_EQ(places.size(), model.positions.size());
  }
}

TEST(Shapes, HaveTheVolumesOfTheirFormulas) {
  constexpr double kPi = 3.14159265358979323846;
  struct Row {
    const char* name;
    double volume;
  };
  // Polygons are inside of what is round: .5 % for 64 columns.
  for (const Row& row :
       {Row{"sphere", 4 * kPi / 3}, Row{"icosphere", 4 * kPi / 3}, Row{"cylinder", 2 * kPi},
        Row{"cone", 2 * kPi / 3}, Row{"paraboloid", kPi / 2}, Row{"torus", 2 * kPi * kPi * 0.16}}) {
    SCOPED_TRACE(row.name);
    const double own = volume(triangulated(shape_of(row.name)));
    EXPECT_LT(own, row.volume);
    EXPECT_GT(own, 0.99 * row.volume);
  }
  EXPECT_EQ(volume(triangulated(shape_of("box"))), 1);
  EXPECT_NEAR(volume(triangulated(shape_of("pyramid"))), 28.0 / 3, 1e-14);  // h/3 (A + B + sqrt AB)
}

TEST(Shapes, CountsAreThoseAskedFor) {
  EXPECT_EQ(triangulated(shape_of("sphere", {1, 256, 129})).triangles.size(), 2 * 256 * 128U);
  EXPECT_EQ(triangulated(shape_of("sphere", {1, 12, 6})).triangles.size(), 2 * 12 * 5U);
  EXPECT_EQ(shape_of("icosphere", {1, 3}).faces.size(), 20 * 64U);
  EXPECT_EQ(shape_of("icosphere", {1, 3}).positions.size(), 10 * 64 + 2U);
  EXPECT_EQ(shape_of("plane", {2, 2, 3, 4}).faces.size(), 12U);
  EXPECT_EQ(shape_of("corrugation", {4, 2, 0.25, 5}).faces.size(), 10U);
}

TEST(Shapes, RoundOnesHaveTheirOwnNormals) {
  const PolygonModel sphere = shape_of("sphere", {2, 24, 12});
  for (const MeshCorner& corner : sphere.corners) {
    const Vector3d& p = sphere.positions[corner.position];
    EXPECT_NEAR(p.norm(), 2, 1e-15);
    if (p.x() == 0 && p.z() == 0) continue;
    EXPECT_NEAR((sphere.normals[corner.normal] - p / 2).norm(), 0, 1e-15);
  }
  // The cap's normal is along (x/a^2, 1, z/a^2).
  const PolygonModel cap = shape_of("cap", {0.9, 0, 16, 4});
  for (const MeshCorner& corner : cap.corners) {
    const Vector3d& p = cap.positions[corner.position];
    const Vector3d expected(p.x() / 0.81, 1, p.z() / 0.81);
    EXPECT_NEAR(p.y(), -(p.x() * p.x() + p.z() * p.z()) / 1.62, 1e-15);
    EXPECT_NEAR((cap.normals[corner.normal] - expected).norm(), 0, 1e-14);
  }
}

TEST(Teapot, IsThePublishedOne) {
  const PolygonModel teapot = shape_of("teapot", {4});
  Vector3d least(0, 0, 0);
  Vector3d most(0, 0, 0);
  for (const Vector3d& p : teapot.positions) {
    least = least.cwiseMin(p);
    most = most.cwiseMax(p);
  }
  EXPECT_EQ(least.x(), -3);
  EXPECT_NEAR(most.x(), 3.43, 0.01);
  EXPECT_EQ(least.y(), 0);
  EXPECT_EQ(most.y(), 3.15);
  EXPECT_EQ(most.z(), 2);
  EXPECT_EQ(least.z(), -2);
  // 32 patches of 16 quads; those at the top of the knob and the middle of the bottom are
  // triangles.
  EXPECT_EQ(teapot.faces.size(), 32 * 16U);
  EXPECT_EQ(triangulated(teapot).triangles.size(), 32 * 32 - 8 * 4U);
  // Open are the rims of pot and lid, two ends of the handle, two of the spout.
  int open = 0;
  const auto edges = edges_of(teapot);
  for (const auto& [edge, count] : edges) {
    EXPECT_EQ(count, 1);
    if (edges.count({edge.second, edge.first}) == 0) ++open;
  }
  EXPECT_EQ(open, 4 * 16);
}

}  // namespace
}  // namespace tristim
