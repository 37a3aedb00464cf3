#include "tristim/render/scanline.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>
#include <utility>

namespace tristim {
namespace {

using Eigen::Vector2d;

std::vector<GouraudVertex> random_triangle(std::mt19937& random) {
  std::uniform_real_distribution<double> place(-4, 36);
  std::uniform_real_distribution<double> intensity(0, 1);
  std::vector<GouraudVertex> triangle;
  for (int i = 0; i < 3; ++i) {
    triangle.push_back({{place(random), place(random)}, intensity(random)});
  }
  return triangle;
}

TEST(ScanlineFill, InterpolatesEdgesByUAndWThenTheSpanByT) {
  const std::vector<GouraudVertex> triangle{{{0, 0}, 0}, {{8, 0}, 1}, {{0, 8}, 0.25}};
  const std::vector<ScanlineRow> rows = scanline_fill(8, 8, triangle);
  ASSERT_EQ(rows.size(), 7U);        // the last one ends on the only centre
  const ScanlineRow& row = rows[3];  // y = 3.5: Q on the edge from C to A, R on that from B to C
  EXPECT_EQ(row.run, (PixelRun{3, 0, 4}));
  EXPECT_EQ(row.span.u, 1 - 3.5 / 8);
  EXPECT_EQ(row.span.w, 3.5 / 8);
  EXPECT_EQ(row.span.t, 0.5 / 4.5);
  EXPECT_EQ(row.span.i_q, 0.25 * 3.5 / 8);
  EXPECT_EQ(row.span.i_r, 1 - 0.75 * 3.5 / 8);
  ASSERT_EQ(row.intensity.size(), 4U);
  EXPECT_EQ(row.intensity[0], row.span.i_p);
}

TEST(ScanlineFill, IncrementsKeepToTheSpansIntensity) {
  std::mt19937 random(1971);
  for (int i = 0; i < 200; ++i) {
    const std::vector<GouraudVertex> triangle = random_triangle(random);
    for (const ScanlineRow& row : scanline_fill(32, 32, triangle)) {
      ASSERT_EQ(row.intensity.size(), static_cast<std::size_t>(row.run.last - row.run.first));
      for (int x = row.run.first; x < row.run.last; ++x) {
        const double expected = gouraud_span(triangle, Vector2d(x + 0.5, row.run.y + 0.5)).i_p;
        EXPECT_NEAR(row.intensity[static_cast<std::size_t>(x - row.run.first)], expected, 2.3e-16);
      }
    }
  }
}

TEST(ScanlineFill, NeighboursLeaveNoGapAndShareNoPixel) {
  std::mt19937 random(1994);
  for (int i = 0; i < 100; ++i) {
    const Vector2d middle = random_triangle(random)[0].at;
    const std::vector<Vector2d> corners{{-5, -5}, {40, -5}, {40, 40}, {-5, 40}};
    std::map<std::pair<int, int>, int> drawn;
    for (std::size_t side = 0; side < 4; ++side) {
      const std::vector<GouraudVertex> part{
          {corners[side], 0}, {corners[(side + 1) % 4], 0}, {middle, 1}};
      for (const ScanlineRow& row : scanline_fill(32, 32, part)) {
        for (int x = row.run.first; x < row.run.last; ++x) ++drawn[{row.run.y, x}];
      }
    }
    EXPECT_EQ(drawn.size(), 32U * 32U);
    for (const auto& [pixel, times] : drawn) EXPECT_EQ(times, 1);
  }
}

TEST(GouraudRow, IsZeroWhereTheRowMissesIt) {
  const std::vector<GouraudVertex> triangle{{{0, 0}, 1}, {{8, 0}, 1}, {{0, 8}, 1}};
  EXPECT_EQ(gouraud_row(triangle, {20, 0, 3}), (std::vector<double>{0, 0, 0}));
  EXPECT_TRUE(gouraud_row(triangle, {2, 3, 3}).empty());
}

TEST(IncrementalDrift, StaysInItsBound) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> intensity(-1, 1);
  for (int i = 0; i < 100; ++i) {
    const IncrementalDrift drift = incremental_drift(0, 1000, intensity(random), intensity(random));
    EXPECT_GT(drift.largest, 0);
    EXPECT_LE(drift.largest, drift.bound);
    EXPECT_LT(drift.bound, 1.3e-4);
  }
  EXPECT_EQ(incremental_drift(5, 5, 0.1, 0.7).bound, 0);
  EXPECT_EQ(incremental_drift(0, 4, 0, 1).largest, 0);  // quarters are exact
}

TEST(NormalsIncremental, AreUnitAndEndAtTheEnds) {
  const Eigen::Vector3d q(0.6, 0, 0.8);
  const Eigen::Vector3d r(0, 0.6, 0.8);
  const auto normals = normals_incremental(10, 20, q, r);
  ASSERT_EQ(normals.size(), 11U);
  for (const Eigen::Vector3d& n : normals) EXPECT_NEAR(n.norm(), 1, 2e-16);
  EXPECT_NEAR((normals.front() - q).norm(), 0, 2e-16);
  EXPECT_NEAR((normals.back() - r).norm(), 0, 2e-16);
  const Eigen::Vector3d middle(0.3, 0.3, 0.8);
  EXPECT_NEAR((normals[5] - middle.normalized()).norm(), 0, 2e-16);
  EXPECT_EQ(normals_incremental(0, 2, q, -q)[1], Eigen::Vector3d(0, 0, 0));
}

TEST(BarycentricByAxes, AgreesWithTheAreas) {
  std::mt19937 random(3);
  for (int i = 0; i < 500; ++i) {
    const std::vector<GouraudVertex> four = random_triangle(random);
    const std::array<GouraudVertex, 3> triangle{four[0], four[1], four[2]};
    const Vector2d p = random_triangle(random)[0].at;
    const Barycentric areas = barycentric(triangle, p);
    const Barycentric axes = barycentric_by_axes(triangle, p);
    const double scale = std::fabs(areas.alpha) + std::fabs(areas.beta) + std::fabs(areas.gamma);
    EXPECT_NEAR(areas.alpha, axes.alpha, 1e-15 * scale);
    EXPECT_NEAR(areas.beta, axes.beta, 1e-15 * scale);
    EXPECT_NEAR(areas.gamma, axes.gamma, 1e-15 * scale);
    EXPECT_NEAR((combination(triangle, areas) - p).norm(), 0, 1e-13 * scale);
  }
}

TEST(BarycentricByAxes, ConvexIsInside) {
  const std::array<GouraudVertex, 3> triangle{{{{0, 0}}, {{8, 0}}, {{0, 8}}}};
  EXPECT_TRUE(is_convex(barycentric(triangle, {1, 1})));
  EXPECT_TRUE(is_convex(barycentric(triangle, {8, 0})));
  EXPECT_FALSE(is_convex(barycentric(triangle, {8.001, 0})));
  const std::array<GouraudVertex, 3> line{{{{0, 0}}, {{1, 1}}, {{2, 2}}}};
  EXPECT_FALSE(is_convex(barycentric(line, {1, 1})));
  EXPECT_EQ(barycentric_by_axes(line, {1, 1}).beta, 0);
}

}  // namespace
}  // namespace tristim
