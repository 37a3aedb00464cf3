#include "tristim/render/gouraud.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace tristim {
namespace {

using Eigen::Vector2d;

constexpr double kLow = 0.25;
const std::array<GouraudVertex, 3> kTriangle{{{{0, 0}, 0, 1}, {{8, 0}, 1, 1}, {{0, 8}, kLow, 2}}};

TEST(GouraudSpan, InterpolatesAlongEdgesThenAlongTheLine) {
  const GouraudSpan span = gouraud_span(kTriangle, Vector2d(1, 4));
  EXPECT_EQ(span.x_q, 0);
  EXPECT_EQ(span.x_r, 4);
  EXPECT_EQ(span.i_q, 0.125);
  EXPECT_EQ(span.i_r, 0.625);
  EXPECT_EQ(span.t, 0.25);
  EXPECT_EQ(span.i_p, 0.25);
  EXPECT_EQ(gouraud_span(kTriangle, Vector2d(1, 9)).i_p, 0);     // misses it
  EXPECT_EQ(gouraud_span(kTriangle, Vector2d(0, 8)).i_p, kLow);  // the vertex alone
}

TEST(Barycentric, IsTheSpansIntensityOnATriangle) {
  const Vector2d p(1, 4);
  const Barycentric parts = barycentric(kTriangle, p);
  EXPECT_EQ(parts.alpha + parts.beta + parts.gamma, 1);
  EXPECT_EQ(parts.beta * 1 + parts.gamma * kLow, gouraud_span(kTriangle, p).i_p);
  const std::array<GouraudVertex, 3> line{{{{0, 0}}, {{1, 1}}, {{2, 2}}}};
  EXPECT_EQ(barycentric(line, p).alpha, 0);
  // parts 3/8, 1/8, 4/8; over w: 3/8, 1/8, 2/8
  EXPECT_EQ(perspective_intensity(kTriangle, p), (0.125 + 0.25 * kLow) / 0.75);
}

TEST(PerspectiveIntensity, CountsTheRatiosOfWAlone) {
  const Vector2d p(1, 1);
  for (const double scale : {5e-324, 1e-300, 1e300}) {
    std::array<GouraudVertex, 3> triangle = kTriangle;
    for (std::size_t i = 0; i < 3; ++i) triangle[i].w = scale * static_cast<double>(1 << i);
    std::array<GouraudVertex, 3> plain = triangle;
    for (GouraudVertex& vertex : plain) vertex.w /= scale;
    EXPECT_EQ(perspective_intensity(triangle, p), perspective_intensity(plain, p));
    triangle[2].w = 1e308;  // the corner is too far away to count
    EXPECT_TRUE(std::isfinite(perspective_intensity(triangle, p)));
  }
}

TEST(GouraudIncremental, EndsAtTheEnd) {
  const std::vector<double> all = gouraud_incremental(-5, 1'000'000, 0.1, 0.7);
  EXPECT_EQ(all.size(), 1'000'006U);
  EXPECT_EQ(all.front(), 0.1);
  EXPECT_EQ(all.back(), 0.7);
  EXPECT_EQ(gouraud_incremental(3, 3, 0.5, 9), std::vector<double>{0.5});
  EXPECT_TRUE(gouraud_incremental(3, 2, 0.5, 9).empty());
}

TEST(GouraudTurned, DependsOnTheAngleForQuadsOnly) {
  const std::vector<GouraudVertex> quad{{{-1, -1}, 0}, {{1, -1}, 0}, {{1, 1}, 1}, {{-1, 1}, 0}};
  const Vector2d p(0.25, 0.25);
  EXPECT_NEAR(gouraud_turned(quad, p, 0), 0.625 * 0.625, 1e-16);
  EXPECT_NEAR(gouraud_turned(quad, p, 360), 0.625 * 0.625, 1e-16);
  EXPECT_GT(gouraud_turned(quad, p, 45) - gouraud_turned(quad, p, 0), -0.2);
  EXPECT_NE(gouraud_turned(quad, p, 45), gouraud_turned(quad, p, 0));
  for (double angle : {0.0, 30.0, 45.0, 90.0}) {
    EXPECT_NEAR(gouraud_turned(kTriangle, Vector2d(1, 4), angle), 0.25, 1e-15);
  }
}

}  // namespace
}  // namespace tristim
