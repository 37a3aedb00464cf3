#include "tristim/render/mesh_normals.h"

#include <gtest/gtest.h>

#include <set>

#include "tests/error_text.h"
#include "tristim/core/find.h"
#include "tristim/render/shapes.h"

namespace tristim {
namespace {

using Eigen::Vector3d;

PolygonModel shape_of(std::string_view name) { return make_shape(*find_by_name(shapes(), name)); }

PolygonMesh polygon_mesh(const PolygonModel& model) {
  PolygonMesh mesh{.vertices = model.positions, .faces = {}, .planes = model.planes};
  for (const PolygonFace& face : model.faces) {
    std::vector<std::size_t>& numbers = mesh.faces.emplace_back();
    for (const MeshCorner& corner : model.corners_of(face)) numbers.push_back(corner.position);
  }
  return mesh;
}

TEST(AverageNormals, WithoutCreasesAreTheVertexNormals) {
  for (const NormalWeighting& weighting : kNormalWeightings) {
    SCOPED_TRACE(weighting.name);
    PolygonModel model = shape_of("pyramid");
    const std::vector<Vector3d> expected = vertex_normals(polygon_mesh(model), weighting);
    average_normals(model, weighting);
    EXPECT_TRUE(has_normals(model));
    for (const MeshCorner& corner : model.corners) {
      EXPECT_EQ(model.normals[corner.normal], expected[corner.position]);
    }
  }
}

// [Shoaff 4.3], without the bottom: (0, 1, 0) + (-1, 1, 0) + (0, 1, 1), in the axes that it has.
TEST(AverageNormals, OfTheTruncatedPyramid) {
  PolygonModel model = shape_of("pyramid");
  model.faces.pop_back();
  model.planes.pop_back();
  average_normals(model, kPlaneNormals);
  const Vector3d normal = model.normals[model.corners[1].normal];  // of the top's front left
  EXPECT_NEAR((normal - Vector3d(-1, 3, 1).normalized()).norm(), 0, 2e-16);
}

TEST(AverageNormals, SplitVerticesAtCreases) {
  // A box has three faces at 90 degrees at each corner.
  for (const auto& [smoothing, normals] : {std::pair(89.0, 24U), {90.0, 8U}, {180.0, 8U}}) {
    PolygonModel box = shape_of("box");
    average_normals(box, kUniformNormals, smoothing);
    EXPECT_EQ(box.normals.size(), normals) << smoothing;
  }
  PolygonModel cylinder = shape_of("cylinder");
  average_normals(cylinder, kAngleNormals, 30);
  std::set<double> heights;
  for (const MeshCorner& corner : cylinder.corners) {
    heights.insert(std::fabs(cylinder.normals[corner.normal].y()));
  }
  EXPECT_EQ(*heights.begin(), 0);
  EXPECT_EQ(heights.size(), 2U);  // 0 on the side, 1 on the ends
  EXPECT_EQ(*heights.rbegin(), 1);
}

TEST(AverageNormals, HangTogetherByEdges) {
  // Two strips that touch in one vertex only, both nearly upright.
  PolygonModel model{.positions = {{0, 0, 0}, {-1, 0.1, 0}, {0, 0.1, 1}, {1, 0, 0}, {0, 0, -1}}};
  add_face(model, std::array{MeshCorner{0}, MeshCorner{1}, MeshCorner{2}});
  add_face(model, std::array{MeshCorner{0}, MeshCorner{3}, MeshCorner{4}});
  PolygonModel all = model;
  average_normals(all, kUniformNormals);
  EXPECT_EQ(all.corners[0].normal, all.corners[3].normal);
  average_normals(model, kUniformNormals, 170);
  EXPECT_NE(model.corners[0].normal, model.corners[3].normal);
}

TEST(AverageNormals, AnglesWeighNoTriangulationIn) {
  PolygonModel quads = shape_of("box");
  PolygonModel triangles = polygon_model(triangulated(quads));
  average_normals(quads, kAngleNormals);
  average_normals(triangles, kAngleNormals);
  for (std::size_t i = 0; i < quads.corners.size(); ++i) {
    const Vector3d& n = quads.normals[quads.corners[i].normal];
    EXPECT_NEAR((n.cwiseAbs() - Vector3d(1, 1, 1).normalized()).norm(), 0, 2e-16);
  }
  for (const MeshCorner& corner : triangles.corners) {
    const Vector3d& n = triangles.normals[corner.normal];
    EXPECT_NEAR((n.cwiseAbs() - Vector3d(1, 1, 1).normalized()).norm(), 0, 3e-16);
  }
}

TEST(AverageNormals, FoldsOfACorrugationAllPointUp) {
  PolygonModel model = shape_of("corrugation");
  average_normals(model, kUniformNormals);
  int inner = 0;
  for (const MeshCorner& corner : model.corners) {
    if (std::fabs(model.positions[corner.position].x()) > 1.9) continue;  // but at the border
    EXPECT_NEAR(model.normals[corner.normal].y(), 1, 2e-16);
    ++inner;
  }
  EXPECT_GT(inner, 40);
}

TEST(AverageNormals, OppositeFacesCancel) {
  PolygonModel leaf{.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}};
  add_face(leaf, std::array{MeshCorner{0}, MeshCorner{1}, MeshCorner{2}});
  add_face(leaf, std::array{MeshCorner{0}, MeshCorner{2}, MeshCorner{1}});
  average_normals(leaf, kUniformNormals);
  EXPECT_EQ(leaf.corners[0].normal, kNoIndex);
  EXPECT_TRUE(leaf.normals.empty());
  average_normals(leaf, kUniformNormals, 170);
  EXPECT_TRUE(has_normals(leaf));
  drop_normals(leaf);
  EXPECT_FALSE(has_normals(leaf));
  EXPECT_EQ(error_text([&] { average_normals(leaf, kPlaneNormals); }),
            "invalid: 0 planes for 2 faces");
}

}  // namespace
}  // namespace tristim
