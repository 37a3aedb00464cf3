#include "tristim/light/normals.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/error_text.h"
#include "tristim/core/find.h"

namespace tristim {
namespace {

using Eigen::Vector3d;

void expect_near(const Vector3d& v, double x, double y, double z, double tolerance = 2e-16) {
  EXPECT_NEAR(v.x(), x, tolerance);
  EXPECT_NEAR(v.y(), y, tolerance);
  EXPECT_NEAR(v.z(), z, tolerance);
}

TEST(Normal, OfPlaneAndOfThreePoints) {
  expect_near(plane_normal(0, 3, 4), 0, 0.6, 0.8);
  EXPECT_EQ(plane_normal(0, 0, 0), Vector3d(0, 0, 0));
  const Vector3d a(1, 1, 1);
  EXPECT_EQ(three_point_normal(a, a + Vector3d(2, 0, 0), a + Vector3d(0, 5, 0)), Vector3d(0, 0, 1));
  EXPECT_EQ(three_point_normal(a, a + Vector3d(0, 5, 0), a + Vector3d(2, 0, 0)),
            Vector3d(0, 0, -1));
  EXPECT_EQ(three_point_normal(a, 2 * a, 3 * a), Vector3d(0, 0, 0));
}

TEST(NewellNormal, IsTwiceTheArea) {
  // An L with a vertex in the middle of its first edge: the first three points lie on a line.
  const std::vector<Vector3d> polygon{{0, 0, 7}, {1, 0, 7}, {2, 0, 7}, {2, 1, 7},
                                      {1, 1, 7}, {1, 2, 7}, {0, 2, 7}};
  EXPECT_EQ(newell_normal(polygon), Vector3d(0, 0, 6));
  EXPECT_EQ(polygon_area(polygon), 3);
  EXPECT_EQ(unit_newell_normal(polygon), Vector3d(0, 0, 1));
  const std::vector<Vector3d> line{{0, 0, 0}, {1, 1, 1}};
  EXPECT_EQ(newell_normal(line), Vector3d(0, 0, 0));
  EXPECT_EQ(unit_newell_normal(line), Vector3d(0, 0, 0));
}

TEST(FacingNormal, IsOnTheEyesSide) {
  const Vector3d up(0, 0, 1);
  EXPECT_EQ(facing_normal(up, Vector3d(0.6, 0, 0.8)), up);
  EXPECT_EQ(facing_normal(up, Vector3d(0.6, 0, -0.8)), -up);
  EXPECT_EQ(facing_normal(up, Vector3d(1, 0, 0)), up);
}

// The truncated pyramid of [Shoaff 4.1], open below.
PolygonMesh pyramid() {
  return {.vertices = {{-1, -1, 1},
                       {1, -1, 1},
                       {1, 1, 1},
                       {-1, 1, 1},
                       {-2, -2, 0},
                       {2, -2, 0},
                       {2, 2, 0},
                       {-2, 2, 0}},
          .faces = {{0, 1, 2, 3}, {4, 5, 1, 0}, {5, 6, 2, 1}, {6, 7, 3, 2}, {7, 4, 0, 3}},
          .planes = {{0, 0, 1}, {0, -1, 1}, {1, 0, 1}, {0, 1, 1}, {-1, 0, 1}}};
}

struct PyramidRow {
  std::string_view weighting;
  double across, up;  // the normal of the first vertex is (across, across, up)
};

// From mpmath with 40 digits; "plane" is the notes' (-1, -1, 3)/sqrt 11.
constexpr PyramidRow kPyramid[] = {{"plane", -0.30151134457776363, 0.90453403373329089},
                                   {"uniform", -0.27059805007309849, 0.92387953251128674},
                                   {"area", -0.276172385369497, 0.92057461789832345},
                                   {"angle", -0.30019384030089099, 0.90541002672314514}};

TEST(VertexNormals, WeighThePyramidsFaces) {
  for (const PyramidRow& row : kPyramid) {
    SCOPED_TRACE(row.weighting);
    const NormalWeighting& weighting = *find_by_name(kNormalWeightings, row.weighting);
    const std::vector<Vector3d> normals = vertex_normals(pyramid(), weighting);
    ASSERT_EQ(normals.size(), 8U);
    expect_near(normals[0], row.across, row.across, row.up);
    expect_near(normals[2], -row.across, -row.across, row.up);
    expect_near(normals[4], -0.40824829046386302, -0.40824829046386302, 0.81649658092772603);
  }
}

TEST(VertexNormals, AreUnitOrZeroWhateverTheWeights) {
  const PolygonMesh folded{.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {9, 9, 9}},
                           .faces = {{0, 1, 2}, {0, 2, 1}, {0, 0, 0}},
                           .planes = {{0, 0, 1}, {0, 0, -1}, {0, 0, 0}}};
  for (const NormalWeighting& weighting : kNormalWeightings) {
    SCOPED_TRACE(weighting.name);
    for (const Vector3d& normal : vertex_normals(folded, weighting)) {
      EXPECT_EQ(normal, Vector3d(0, 0, 0));
    }
  }
}

TEST(VertexNormals, RefuseWhatTheMeshHasNot) {
  PolygonMesh mesh = pyramid();
  mesh.planes.pop_back();
  EXPECT_EQ(error_text([&] { (void)vertex_normals(mesh, kPlaneNormals); }),
            "invalid: 4 planes for 5 faces");
  mesh.faces[1][2] = 8;
  EXPECT_EQ(error_text([&] { (void)vertex_normals(mesh, kAreaNormals); }),
            "invalid: face 1 names vertex 8 of 8");
}

}  // namespace
}  // namespace tristim
