#include "tristim/render/shared_vertices.h"

#include <gtest/gtest.h>

#include "tests/error_text.h"

namespace tristim {
namespace {

// A square on top of two: vertex 4 lies on the upper one's lower edge, as in [Shoaff 4.3].
PolygonMesh three_squares() {
  return {.vertices = {{0, 1, 0},
                       {4, 1, 0},
                       {4, 3, 0},
                       {0, 3, 0},
                       {1, 1, 0},
                       {0, 0, 0},
                       {1, 0, 0},
                       {4, 0, 0},
                       {2, 1, 0}},
          .faces = {{0, 1, 2, 3}, {5, 6, 4, 0}, {6, 7, 1, 4}},
          .planes = {}};
}

TEST(TJunctions, FindsTheVertexThatIsNotShared) {
  const std::vector<TJunction> found = t_junctions(three_squares());
  ASSERT_EQ(found.size(), 1U);  // no face names vertex 8
  EXPECT_EQ(found[0].vertex, 4U);
  EXPECT_EQ(found[0].face, 0U);
  EXPECT_EQ(found[0].edge, 0U);
  EXPECT_EQ(found[0].t, 0.25);
  const std::vector<double> intensities{0, 1, 0, 0, 0.5, 0, 0, 0, 0};
  EXPECT_EQ(intensity_gap(three_squares(), found[0], intensities), 0.25);
}

TEST(TJunctions, SharedVerticesAreNone) {
  PolygonMesh mesh = three_squares();
  mesh.faces[0] = {0, 4, 1, 2, 3};
  EXPECT_TRUE(t_junctions(mesh).empty());
}

TEST(TJunctions, KeepsToItsTolerance) {
  PolygonMesh mesh = three_squares();
  mesh.vertices[4].y() += 0.02;
  EXPECT_TRUE(t_junctions(mesh).empty());
  EXPECT_EQ(t_junctions(mesh, 0.01).size(), 1U);
  mesh.faces[1][0] = 9;
  EXPECT_EQ(error_text([&] { (void)t_junctions(mesh); }), "invalid: face 1 names vertex 9 of 9");
}

}  // namespace
}  // namespace tristim
