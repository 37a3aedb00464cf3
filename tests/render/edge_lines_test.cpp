#include "lib/render/edge_lines.h"

#include <gtest/gtest.h>

#include "tests/render/scenes.h"

namespace tristim {
namespace {

// The unit cube about the origin, twelve triangles, each face with corners of its own.
Mesh cube() {
  Mesh mesh;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {-0.5, 0.5}) {
      const auto first = static_cast<std::uint32_t>(mesh.positions.size());
      for (const auto& [u, v] : {std::pair{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}}) {
        Eigen::Vector3d p;
        p[axis] = side;
        p[(axis + 1) % 3] = side > 0 ? u : v;
        p[(axis + 2) % 3] = side > 0 ? v : u;
        mesh.positions.push_back(p);
      }
      for (const auto& [i, j, k] : {std::array{0U, 1U, 2U}, std::array{0U, 2U, 3U}}) {
        MeshTriangle triangle;
        triangle.corners = {MeshCorner{first + i}, MeshCorner{first + j}, MeshCorner{first + k}};
        mesh.triangles.push_back(triangle);
      }
    }
  }
  return mesh;
}

TEST(EdgesOf, JoinsCornersAtTheSamePlace) {
  RenderReport report;
  const detail::World world = detail::world_of(test_scene(cube()), report);
  const auto edges = detail::edges_of(world);
  EXPECT_EQ(edges.size(), 18U);  // twelve of the cube and a diagonal in each face
  for (const auto& edge : edges) EXPECT_NE(edge.other, kNoIndex);
  const detail::World square = detail::world_of(test_scene(test_square()), report);
  int borders = 0;
  for (const auto& edge : detail::edges_of(square)) borders += edge.other == kNoIndex ? 1 : 0;
  EXPECT_EQ(borders, 4);
}

Scene drawing() {
  Scene scene = test_scene(cube());
  scene.materials[0].model = kFlatColor;
  scene.materials[0].surface.od = {1, 1, 1};
  scene.camera = {.eye = {2, 3, 5}, .orthographic = true};
  scene.picture = {.width = 120, .height = 120};
  scene.edges.color = {1, 0, 0};
  scene.edges.width = 3;
  return scene;
}

int count_red(const Rendered& picture) {
  int red = 0;
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      red += picture.at(x, y, 0) == 1 && picture.at(x, y, 1) == 0 ? 1 : 0;
    }
  }
  return red;
}

TEST(EdgeLines, AreTheOutlineAndTheCreasesThatAreSeen) {
  // Directions of the cube's edges in the picture, in pixels.
  const Eigen::Vector3d back = Eigen::Vector3d(2, 3, 5).normalized();
  double seen = 0;
  for (int axis = 0; axis < 3; ++axis) seen += 60 * std::sqrt(1 - back[axis] * back[axis]);
  Scene scene = drawing();
  EXPECT_EQ(count_red(rendered(scene)), 0);
  scene.edges.silhouettes = true;
  const int outline = count_red(rendered(scene));
  EXPECT_NEAR(outline, 3 * 2 * seen, 40);  // of each direction two edges are on the outline
  scene.edges.creases = true;
  EXPECT_NEAR(count_red(rendered(scene)), 3 * 3 * seen, 60);  // and one is inside of it
  scene.edges.silhouettes = false;
  scene.edges.crease_deg = 91;
  EXPECT_EQ(count_red(rendered(scene)), 0);
}

// A crease in the middle of the cube's picture, and nothing on the faces' diagonals.
TEST(EdgeLines, LieOnTheirEdges) {
  Scene scene = drawing();
  scene.edges.creases = true;
  const Rendered picture = rendered(scene);
  const Eigen::Vector3d back = Eigen::Vector3d(2, 3, 5).normalized();
  const Eigen::Vector3d right = Eigen::Vector3d(5, 0, -2).normalized();
  const Eigen::Vector3d up(back.y() * right.z() - back.z() * right.y(),
                           back.z() * right.x() - back.x() * right.z(),
                           back.x() * right.y() - back.y() * right.x());
  const auto at = [&](const Eigen::Vector3d& p) {
    return picture.at(static_cast<int>(60 + 60 * p.dot(right)),
                      static_cast<int>(60 - 60 * p.dot(up)), 1);
  };
  EXPECT_EQ(at({0.5, 0.5, 0.2}), 0);
  EXPECT_EQ(at({0.5, 0.1, 0.5}), 0);
  EXPECT_EQ(at({0.2, 0.5, 0.5}), 0);
  EXPECT_EQ(at({0.2, 0.2, 0.5}), 1);
  EXPECT_EQ(at({0.5, 0.2, -0.2}), 1);
}

TEST(EdgeLines, EndAtTheNearPlaneAndThePicture) {
  Scene scene = drawing();
  scene.edges.silhouettes = scene.edges.creases = true;
  scene.camera = {.eye = {0, 0, 0.6}, .target = {0.3, 0.2, 0}, .fov_deg = 120, .near = 0.01};
  scene.materials[0].two_sided = true;
  scene.objects[0].world_from_object.topLeftCorner<3, 3>() *= 3;  // the camera is inside
  EXPECT_GT(count_red(rendered(scene)), 50);
}

}  // namespace
}  // namespace tristim
