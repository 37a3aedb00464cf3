#include "lib/render/tile_draw.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <random>
#include <vector>

namespace tristim::detail {
namespace {

using Wide = __int128;

constexpr int kBits = 16;
constexpr std::int32_t kPixel = 1 << kBits;

VisibilityPlane plane_of(const TileRect& rect) {
  VisibilityPlane plane;
  plane.clear(rect);
  return plane;
}

std::vector<std::uint32_t> numbers(std::size_t count) {
  std::vector<std::uint32_t> list(count);
  std::iota(list.begin(), list.end(), 0U);
  return list;
}

// Twice the area of a, b, c, above 0 for what is drawn.
Wide area(const FixedPoint& a, const FixedPoint& b, const FixedPoint& c) {
  return Wide{std::int64_t{c.x} - a.x} * (std::int64_t{b.y} - a.y) -
         Wide{std::int64_t{b.x} - a.x} * (std::int64_t{c.y} - a.y);
}

// Corners up to `reach` pixels from the middle of `rect`, in an order that is drawn.
DeviceTriangle random_triangle(std::mt19937& random, const TileRect& rect, double reach) {
  std::uniform_real_distribution<double> away(-reach, reach);
  std::uniform_real_distribution<double> nearness(0.1, 2);
  DeviceTriangle triangle;
  do {
    for (std::size_t i = 0; i < 3; ++i) {
      triangle.at[i] = {static_cast<std::int32_t>(
                            std::lround((rect.x0 + rect.width / 2 + away(random)) * kPixel)),
                        static_cast<std::int32_t>(
                            std::lround((rect.y0 + rect.height / 2 + away(random)) * kPixel))};
      triangle.nearness[i] = nearness(random);
    }
  } while (area(triangle.at[0], triangle.at[1], triangle.at[2]) == 0);
  if (area(triangle.at[0], triangle.at[1], triangle.at[2]) < 0) {
    std::swap(triangle.at[1], triangle.at[2]);
  }
  return triangle;
}

// By rational arithmetic: the row's line through the sample enters the triangle at or left of it
// and leaves it right of it; an edge reaches from its upper end down to, not including, its lower
// end.
bool covers(const DeviceTriangle& triangle, std::int64_t x, std::int64_t y) {
  int crossings = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    FixedPoint high = triangle.at[i];
    FixedPoint low = triangle.at[(i + 1) % 3];
    if (high.y > low.y) std::swap(high, low);
    if (y < high.y || y >= low.y) continue;
    // high.x + (low.x - high.x) (y - high.y) / (low.y - high.y) <= x
    const Wide height = std::int64_t{low.y} - high.y;
    const Wide along = Wide{std::int64_t{low.x} - high.x} * (y - high.y);
    if (along <= (Wide{x} - high.x) * height) ++crossings;
  }
  return crossings == 1;
}

class Coverage : public testing::TestWithParam<double> {};
INSTANTIATE_TEST_SUITE_P(Reach, Coverage, testing::Values(0.7, 3.0, 20.0, 60.0, 300.0, 15000.0));

TEST_P(Coverage, IsThatOfRationalArithmetic) {
  std::mt19937 random(20260101);
  const TileRect rect{.x0 = 96, .y0 = 33, .width = 64, .height = 50};
  for (int k = 0; k < 150; ++k) {
    const std::vector<DeviceTriangle> triangle{random_triangle(random, rect, GetParam())};
    const SampleOffset offset{k % 2 == 0 ? kPixel / 2 : 4711, k % 3 == 0 ? kPixel / 2 : 31337};
    VisibilityPlane plane = plane_of(rect);
    draw_triangles(triangle, numbers(1), kBits, offset, plane);
    for (int y = 0; y < rect.height; ++y) {
      for (int x = 0; x < rect.width; ++x) {
        const bool drawn = plane.id[static_cast<std::size_t>(y * rect.width + x)] == 0;
        const auto at = [](int pixel, std::int32_t shift) {
          return std::int64_t{pixel} * kPixel + shift;
        };
        ASSERT_EQ(drawn, covers(triangle[0], at(rect.x0 + x, offset.x), at(rect.y0 + y, offset.y)))
            << "triangle " << k << ", pixel " << x << " " << y;
      }
    }
  }
}

// Corners on the samples themselves: the rule of the edges decides.
TEST(DrawTriangles, GiveASampleOnAnEdgeToOneOfItsTriangles) {
  const auto at = [](int x, int y) {
    return FixedPoint{x * kPixel + kPixel / 2, y * kPixel + kPixel / 2};
  };
  // A square of 8 triangles about a corner.
  const std::array<FixedPoint, 8> ring{at(2, 2),   at(7, 2),  at(12, 2), at(12, 7),
                                       at(12, 12), at(7, 12), at(2, 12), at(2, 7)};
  std::vector<int> times(16 * 16, 0);
  for (std::size_t i = 0; i < 8; ++i) {
    DeviceTriangle triangle;
    triangle.at = {at(7, 7), ring[(i + 1) % 8], ring[i]};
    triangle.nearness = {1, 1, 1};
    ASSERT_GT(area(triangle.at[0], triangle.at[1], triangle.at[2]), 0);
    VisibilityPlane plane = plane_of({0, 0, 16, 16});
    draw_triangles(std::vector{triangle}, numbers(1), kBits, {kPixel / 2, kPixel / 2}, plane);
    for (std::size_t p = 0; p < times.size(); ++p) times[p] += plane.id[p] == 0 ? 1 : 0;
  }
  for (int y = 0; y < 16; ++y) {
    for (int x = 0; x < 16; ++x) {
      // The left and upper sides belong to the square.
      const bool inside = x >= 2 && x < 12 && y >= 2 && y < 12;
      EXPECT_EQ(times[static_cast<std::size_t>(y * 16 + x)], inside ? 1 : 0) << x << " " << y;
    }
  }
}

TEST(DrawTriangles, InVectorsAreTheDefinition) {
  std::mt19937 random(7);
  const TileRect rect{.x0 = -16, .y0 = 64, .width = 96, .height = 40};
  for (const double reach : {1.5, 12.0, 200.0}) {
    std::vector<DeviceTriangle> triangles;
    for (int i = 0; i < 300; ++i) triangles.push_back(random_triangle(random, rect, reach));
    VisibilityPlane fast = plane_of(rect);
    VisibilityPlane slow = plane_of(rect);
    draw_triangles(triangles, numbers(300), kBits, {1000, 50000}, fast);
    draw_triangles_scalar(triangles, numbers(300), kBits, {1000, 50000}, slow);
    EXPECT_EQ(fast.id, slow.id);
    EXPECT_EQ(fast.nearness, slow.nearness);
  }
}

TEST(DrawTriangles, KeepTheNearestAndTheFirstOfEquals) {
  DeviceTriangle far;
  far.at = {FixedPoint{0, 0}, FixedPoint{0, 20 * kPixel}, FixedPoint{20 * kPixel, 0}};
  far.nearness = {1, 1, 1};
  DeviceTriangle near = far;
  near.nearness = {2, 2, 2};
  VisibilityPlane plane = plane_of({0, 0, 16, 16});
  draw_triangles(std::vector{far, near, near, far}, numbers(4), kBits, {kPixel / 2, kPixel / 2},
                 plane);
  EXPECT_EQ(plane.id[0], 1U);
  EXPECT_EQ(plane.nearness[0], 2.0F);
}

// 1/w is linear in the picture.
TEST(DrawTriangles, InterpolateNearnessAlongThePicture) {
  std::mt19937 random(3);
  const TileRect rect{.x0 = 32, .y0 = 0, .width = 64, .height = 64};
  for (int k = 0; k < 50; ++k) {
    const DeviceTriangle triangle = random_triangle(random, rect, 40);
    VisibilityPlane plane = plane_of(rect);
    draw_triangles(std::vector{triangle}, numbers(1), kBits, {kPixel / 2, kPixel / 2}, plane);
    const auto [a, b, c] = triangle.at;
    const auto whole = static_cast<double>(area(a, b, c));
    for (int i = 0; i < rect.width * rect.height; ++i) {
      if (plane.id[static_cast<std::size_t>(i)] != 0) continue;
      const FixedPoint p{(rect.x0 + i % rect.width) * kPixel + kPixel / 2,
                         (rect.y0 + i / rect.width) * kPixel + kPixel / 2};
      const double expected = (static_cast<double>(area(p, b, c)) * triangle.nearness[0] +
                               static_cast<double>(area(a, p, c)) * triangle.nearness[1] +
                               static_cast<double>(area(a, b, p)) * triangle.nearness[2]) /
                              whole;
      // Largest error measured: 3e-7, of slopes of up to 1 a pixel.
      ASSERT_NEAR(plane.nearness[static_cast<std::size_t>(i)], expected, 2e-6);
    }
  }
}

}  // namespace
}  // namespace tristim::detail
